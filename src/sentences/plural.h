// Texts that differ in singular and plural: the n-form of tr, with numbers grouped in thousands.
#pragma once

#include <QString>

namespace mapwright::sentences {

/// "1 submap", "12,480 submaps" out of tr("%1 submaps", nullptr, formOf(count)). English needs no file of
/// translations for that: this room knows the singulars (kSingulars), as soon as there is a QCoreApplication.
QString counted(const QString& translated, qint64 count);
/// What the n-form of tr takes.
int formOf(qint64 count);

/// The English singular of a text that is written in the plural; null where it is the same.
QString singularOf(const char* plural);

}  // namespace mapwright::sentences
