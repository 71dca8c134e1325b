#include "net/plain_sentences.h"

#include <algorithm>
#include <array>

#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include "net/faults.h"

namespace mapwright::net {

namespace {

constexpr qsizetype kMaxErrorBody = 64 * 1024;  // the message of an error is at its beginning

int portOf(const QUrl& url) {
  const QString scheme = url.scheme();
  const bool secure = scheme == QLatin1String("https") || scheme == QLatin1String("wss");
  return url.port(secure ? 443 : 80);
}

const QString kElements = QStringLiteral(
    "(?:a|address|article|b|big|blockquote|body|br|button|center|code|dd|div|dl|dt|em|font|footer|form|h[1-6]"
    "|"
    "head|header|hr|html|i|img|input|label|li|link|main|meta|nav|ol|p|pre|script|section|small|span|strong|"
    "style|sub|sup|svg|table|tbody|td|th|thead|title|tr|tt|u|ul)");

/// Ordinary texts contain angle brackets, too: "<class 'str'>", "<filename>".
enum class Markup { None, Elements, Page };

Markup markupIn(const QString& text, bool said_to_be_html) {
  static const QRegularExpression kPage(QStringLiteral("^\\s*<(!doctype|html)\\b"),
                                        QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression kClosed(QLatin1String("</") + kElements + QLatin1String("\\s*>"),
                                          QRegularExpression::CaseInsensitiveOption);
  if (kPage.match(text).hasMatch()) return Markup::Page;
  return said_to_be_html || kClosed.match(text).hasMatch() ? Markup::Elements : Markup::None;
}

QString withoutTags(QString text, Markup markup) {
  if (markup == Markup::None) return text;
  static const QRegularExpression kUnseen(
      QStringLiteral("<(script|style|head)\\b[^<>]*>.*?(</\\1\\s*>|$)|<!--.*?(-->|$)"),
      QRegularExpression::CaseInsensitiveOption | QRegularExpression::DotMatchesEverythingOption);
  static const QRegularExpression kTag(QStringLiteral("</?[A-Za-z!][^<>]*(>|$)"));
  static const QRegularExpression kElement(QLatin1String("</?") + kElements + QLatin1String("\\b[^<>]*(>|$)"),
                                           QRegularExpression::CaseInsensitiveOption);
  text.replace(kUnseen, QStringLiteral(" "));
  text.replace(markup == Markup::Page ? kTag : kElement, QStringLiteral(" "));
  constexpr std::array<std::pair<const char16_t*, char16_t>, 6> kEntities{{{u"&nbsp;", u' '},
                                                                           {u"&quot;", u'"'},
                                                                           {u"&#39;", u'\''},
                                                                           {u"&lt;", u'<'},
                                                                           {u"&gt;", u'>'},
                                                                           {u"&amp;", u'&'}}};
  for (const auto& [entity, character] : kEntities) {
    text.replace(QStringView(entity).toString(), QString(QChar(character)));
  }
  return text;
}

}  // namespace

QString plainText(const QString& text) {
  QString plain = text.left(kMaxErrorBody);
  for (QChar& character : plain) {
    if (character == u'<') {
      character = QChar(u'\u2039');
    } else if (character == u'>') {
      character = QChar(u'\u203a');
    } else if (character.category() == QChar::Other_Control || character.category() == QChar::Other_Format) {
      character = u' ';
    }
  }
  plain = plain.simplified();
  if (plain.size() > kMaxSentence) {
    plain.truncate(kMaxSentence - 1);
    if (plain.back().isHighSurrogate()) {
      plain.chop(1);
    }
    plain += QChar(u'\u2026');
  }
  return plain;
}

namespace {

QString textIn(const QString& body, bool said_to_be_html) {
  return plainText(withoutTags(body, markupIn(body, said_to_be_html)));
}

}  // namespace

QString errorText(const QByteArray& body, const QByteArray& content_type) {
  const QByteArray beginning = body.left(kMaxErrorBody).trimmed();
  if (beginning.startsWith('{') || content_type.contains("json")) {
    const QJsonObject object = QJsonDocument::fromJson(beginning).object();
    for (const auto* member : {u"detail", u"message", u"error"}) {
      const QString text = textIn(object.value(QStringView(member)).toString(), false);
      if (!text.isEmpty()) {
        return text;
      }
    }
    return {};
  }
  const bool binary = content_type.startsWith("image/") || content_type.contains("octet-stream") ||
                      content_type.contains("protobuf") || beginning.contains('\0');
  return binary ? QString() : textIn(QString::fromUtf8(beginning), content_type.contains("html"));
}

QString hostAndPort(const QUrl& url) {
  const QString host = url.host();
  const QString shown = host.contains(u':') ? u'[' + host + u']' : host;
  return plainText(QStringLiteral("%1:%2").arg(shown).arg(portOf(url)));
}

QString durationWords(qint64 ms) {
  return ms < 1000 ? QStringLiteral("%1 ms").arg(ms) : QStringLiteral("%1 s").arg(double(ms) / 1000);
}

bool sameOrigin(const QUrl& a, const QUrl& b) {
  return a.scheme() == b.scheme() && a.host() == b.host() && portOf(a) == portOf(b);
}

QByteArray headerSafe(const QByteArray& value) {
  QByteArray safe;
  std::copy_if(value.begin(), value.end(), std::back_inserter(safe),
               [](char c) { return std::uint8_t(c) >= 0x20 && c != 0x7f; });
  return safe;
}

Fault faultOf(const FaultCode& code, const QStringList& arguments) {
  Fault fault(code);
  for (const QString& argument : arguments) fault.arguments.emplace_back(argument.toStdString());
  return fault;
}

}  // namespace mapwright::net
