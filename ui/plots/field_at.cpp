#include "ui/plots/field_at.h"

#include <vector>

#include <QJsonArray>
#include <QJsonDocument>

namespace mapwright::window {

namespace {

/// Past the closing quote.
qsizetype endOfString(const QString& text, qsizetype at) {
  for (qsizetype i = at + 1; i < text.size(); ++i) {
    if (text[i] == QLatin1Char('\\')) {
      ++i;
    } else if (text[i] == QLatin1Char('"')) {
      return i + 1;
    }
  }
  return text.size();
}

std::string unescaped(const QString& quoted) {
  const QByteArray json = '[' + quoted.toUtf8() + ']';
  return QJsonDocument::fromJson(json).array().at(0).toString().toStdString();
}

bool isPlottable(const QString& value) {
  if (value == QLatin1String("true") || value == QLatin1String("false") || value == QLatin1String("null"))
    return true;
  bool number = false;
  (void)value.toDouble(&number);
  return number;
}

struct Level {
  bool array = false;
  std::size_t index = 0;
  std::string key = {};
  bool has_key = false;  // and its value comes next
  qsizetype key_from = 0, key_until = 0;
};

series::FieldPath pathOf(const std::vector<Level>& levels, const QString& topic) {
  series::FieldPath path{topic.toStdString(), {}};
  for (const Level& level : levels) {
    if (level.array) {
      path.steps.emplace_back(level.index);
    } else {
      path.steps.emplace_back(level.key);
    }
  }
  return path;
}

}  // namespace

std::optional<FieldAt> fieldAt(const QString& text, qsizetype place, const QString& topic) {
  std::vector<Level> levels;
  for (qsizetype i = 0; i < text.size();) {
    const QChar c = text[i];
    const bool names = !levels.empty() && !levels.back().array && !levels.back().has_key;
    if (c == QLatin1Char('{') || c == QLatin1Char('[')) {
      if (levels.size() >= series::FieldPath::kMostSteps) return std::nullopt;
      levels.push_back({.array = c == QLatin1Char('[')});
      ++i;
    } else if (c == QLatin1Char('}') || c == QLatin1Char(']')) {
      if (levels.empty()) return std::nullopt;
      levels.pop_back();
      ++i;
    } else if (c == QLatin1Char(',')) {
      if (!levels.empty()) {
        ++levels.back().index;
        levels.back().has_key = false;
      }
      ++i;
    } else if (c == QLatin1Char('"') && names) {
      const qsizetype end = endOfString(text, i);
      levels.back().key = unescaped(text.mid(i, end - i));
      levels.back().has_key = true;
      levels.back().key_from = i;
      levels.back().key_until = end;
      i = end;
    } else if (c.isSpace() || c == QLatin1Char(':')) {
      ++i;
    } else {
      // A value; a truncated string is followed by a note.
      qsizetype end = c == QLatin1Char('"') ? endOfString(text, i) : i;
      while (end < text.size() && !QStringView(u",]}\n").contains(text[end])) ++end;
      const bool here = place >= i && place < end;
      const bool on_key = !levels.empty() && !levels.back().array && place >= levels.back().key_from &&
                          place < levels.back().key_until;
      if (here || on_key) {
        QString value = text.mid(i, end - i).trimmed();
        if (value.startsWith(QLatin1Char('"')) && value.endsWith(QLatin1Char('"')) && value.size() > 2)
          value = value.mid(1, value.size() - 2);
        if (levels.empty() || !isPlottable(value)) return std::nullopt;
        return FieldAt{pathOf(levels, topic), i, end};
      }
      i = std::max(end, i + 1);
    }
    if (i > place + 100'000) break;
  }
  return std::nullopt;
}

}  // namespace mapwright::window
