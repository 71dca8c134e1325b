// Words of robots, servers and the system made harmless, and parts of addresses as people write them. Pure
// functions; what they return is plain text, never markup.
#pragma once

#include <QByteArray>
#include <QString>
#include <QUrl>

namespace mapwright::net {

inline constexpr qsizetype kMaxSentence = 300;  // characters

/// At most kMaxSentence characters on one line, without control characters; angle brackets are others that no
/// markup begins with, and what stands between them stays.
QString plainText(const QString& text);
/// What an error's body says: the text of a JSON object's detail, message or error, or of a short plain or
/// HTML page, of which tags are left out; empty when there is nothing to show.
QString errorText(const QByteArray& body, const QByteArray& content_type);
/// "10.0.0.7:8090": where a URL leads, the default port of its scheme filled in.
QString hostAndPort(const QUrl& url);
/// "1.5 s", "250 ms".
QString durationWords(qint64 ms);
/// Scheme, host and port are the same.
bool sameOrigin(const QUrl& a, const QUrl& b);
/// A header value that cannot break out of its line.
QByteArray headerSafe(const QByteArray& value);

}  // namespace mapwright::net
