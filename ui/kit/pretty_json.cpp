#include "ui/kit/pretty_json.h"

#include <QCoreApplication>

#include "ui/kit/status_text.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr qsizetype kShortList = 100;

/// The end (after the bracket) of a short list or object at `at` without nested ones; -1 = it is not one.
qsizetype endOfShort(const QString& text, qsizetype at) {
  const QChar close = text[at] == QLatin1Char('[') ? QLatin1Char(']') : QLatin1Char('}');
  bool quoted = false;
  for (qsizetype i = at + 1; i < text.size() && i - at < kShortList; ++i) {
    const QChar c = text[i];
    if (quoted) {
      if (c == QLatin1Char('\\')) ++i;
      if (c == QLatin1Char('"')) quoted = false;
    } else if (c == QLatin1Char('"')) {
      quoted = true;
    } else if (c == close) {
      return i + 1;
    } else if (c == QLatin1Char('[') || c == QLatin1Char('{')) {
      return -1;
    }
  }
  return -1;
}

qsizetype endOfQuoted(const QString& text, qsizetype at) {
  for (qsizetype i = at + 1; i < text.size(); ++i) {
    if (text[i] == QLatin1Char('\\')) {
      ++i;
    } else if (text[i] == QLatin1Char('"')) {
      return i + 1;
    }
  }
  return text.size();
}

}  // namespace

QString prettyJson(const QByteArray& bytes, qsizetype limit, qsizetype longest_string) {
  const QString text = QString::fromUtf8(words::escapedJson(bytes)).trimmed();
  const auto cutNote = [&] {
    return QLatin1Char('\n') +
           QCoreApplication::translate("window", "… truncated: %1 in total").arg(bytesText(bytes.size()));
  };
  if (!text.startsWith(QLatin1Char('{')) && !text.startsWith(QLatin1Char('['))) {
    return text.size() <= limit ? text : text.left(limit) + cutNote();
  }
  QString out;
  int depth = 0;
  const auto newLine = [&] {
    out += QLatin1Char('\n');
    out += QString(2 * qBound(0, depth, 40), QLatin1Char(' '));
  };
  for (qsizetype i = 0; i < text.size();) {
    if (out.size() > limit) return out + cutNote();
    const QChar c = text[i];
    if (c == QLatin1Char('"')) {
      const qsizetype end = endOfQuoted(text, i);
      if (end - i - 2 > longest_string) {
        out += QStringView(text).mid(i, longest_string + 1);
        out += QStringLiteral("…\" (%1 characters)").arg(countText(end - i - 2));
      } else {
        out += QStringView(text).mid(i, end - i);
      }
      i = end;
      continue;
    }
    if (c == QLatin1Char('[') || (c == QLatin1Char('{') && depth > 0)) {
      const qsizetype end = endOfShort(text, i);
      if (end > 0) {
        out += QStringView(text).mid(i, end - i);
        i = end;
        continue;
      }
    }
    if (c == QLatin1Char('[') || c == QLatin1Char('{')) {
      out += c;
      ++depth;
      newLine();
    } else if (c == QLatin1Char(']') || c == QLatin1Char('}')) {
      --depth;
      newLine();
      out += c;
    } else if (c == QLatin1Char(',')) {
      out += c;
      newLine();
    } else if (c == QLatin1Char(':')) {
      out += QStringLiteral(": ");
    } else if (!c.isSpace()) {
      out += c;
    }
    ++i;
  }
  return out;
}

}  // namespace mapwright::ui
