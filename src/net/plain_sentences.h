// Makes texts of robots, servers and the system harmless, and formats parts of addresses. Pure functions; the
// results are plain text, never markup.
#pragma once

#include <QByteArray>
#include <QString>
#include <QUrl>

namespace mapwright::net {

inline constexpr qsizetype kMaxSentence = 300;  // characters

/// At most kMaxSentence characters on one line, without control characters; angle brackets are replaced so
/// that they cannot start markup, the text between them stays.
QString plainText(const QString& text);
/// The text of an error body: detail, message or error of a JSON object, or a short plain or HTML page
/// without its tags; empty if there is nothing to show.
QString errorText(const QByteArray& body, const QByteArray& content_type);
/// "10.0.0.7:8090": the host of a URL with its port, or the default port of the scheme.
QString hostAndPort(const QUrl& url);
/// "1.5 s", "250 ms".
QString durationWords(qint64 ms);
/// Same scheme, host and port.
bool sameOrigin(const QUrl& a, const QUrl& b);
/// A header value that cannot break out of its line.
QByteArray headerSafe(const QByteArray& value);

}  // namespace mapwright::net
