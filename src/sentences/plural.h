// Texts with singular and plural: the n-form of tr, with numbers grouped in thousands.
#pragma once

#include <QString>

namespace mapwright::sentences {

/// "1 submap", "12,480 submaps" from tr("%1 submaps", nullptr, formOf(count)). English needs no translation
/// file for that: this room knows the singulars (kSingulars) as soon as there is a QCoreApplication.
QString counted(const QString& translated, qint64 count);
/// The count for the n-form of tr.
int formOf(qint64 count);

/// The English singular of a plural text; null if it is the same.
QString singularOf(const char* plural);

}  // namespace mapwright::sentences
