// words/plain.h and words/sentences.h for QString.
#pragma once

#include <QByteArray>
#include <QCoreApplication>
#include <QString>

#include "words/plain.h"
#include "words/sentences.h"

namespace mapwright::words {

inline QString plainLine(const QString& text) {
  return QString::fromStdString(plainLine(std::string_view(text.toStdString())));
}
inline QString plainText(const QString& text) {
  return QString::fromStdString(plainText(std::string_view(text.toStdString())));
}
/// A name: one line, trimmed, with single blanks.
inline QString plainName(const QString& name) { return plainLine(name).simplified(); }
inline QString plainName(const std::string& name) { return plainName(QString::fromStdString(name)); }
inline QByteArray escapedJson(const QByteArray& json) {
  return QByteArray::fromStdString(escapedJson(std::string_view(json.constData(), std::size_t(json.size()))));
}
inline bool chineseIsSpoken() {
  return QCoreApplication::translate("Punctuation", ".", "the end of a sentence") == QStringLiteral("。");
}
inline QString asSentence(const QString& words) {
  return QString::fromStdString(asSentence(words.toStdString(), chineseIsSpoken()));
}
inline QString because(const QString& what, const QString& reason) {
  return QString::fromStdString(because(what.toStdString(), reason.toStdString(), chineseIsSpoken()));
}

}  // namespace mapwright::words
