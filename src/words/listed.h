// Joins words and clauses as the language that is spoken does.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace mapwright::words {

/// "door, wall"; in Chinese "门、墙".
inline QString listed(const QStringList& words) {
  return words.join(QCoreApplication::translate("Punctuation", ", ", "between the words of a list"));
}
/// "2 walls moved; 1 door renamed": of parts that may have commas in them.
inline QString joined(const QStringList& clauses) {
  return clauses.join(QCoreApplication::translate("Punctuation", "; ", "between clauses"));
}
/// Sentences, one after another: with blanks between them, but none behind Chinese stops, which have room of
/// their own. Empty ones are left out.
inline QString paragraph(const QStringList& sentences) {
  QString text;
  for (const QString& sentence : sentences) {
    if (sentence.isEmpty()) continue;
    if (!text.isEmpty() && !QStringLiteral("。！？；：）").contains(text.back())) text += QLatin1Char(' ');
    text += sentence;
  }
  return text;
}
/// "Speed: fast": what it is about, and what is said of it. The address "demo:" has a colon of its own.
inline QString about(const QString& subject, const QString& said) {
  if (subject.endsWith(QLatin1Char(':'))) return subject + QLatin1Char(' ') + said;
  return QCoreApplication::translate("Punctuation", "%1: %2", "a subject, and what is said of it")
      .arg(subject, said);
}

}  // namespace mapwright::words
