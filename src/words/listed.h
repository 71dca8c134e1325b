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
/// "Speed: fast": what it is about, and what is said of it.
inline QString about(const QString& subject, const QString& said) {
  return QCoreApplication::translate("Punctuation", "%1: %2", "a subject, and what is said of it")
      .arg(subject, said);
}

}  // namespace mapwright::words
