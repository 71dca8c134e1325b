// Texts with singular and plural: the n-form of tr, with numbers grouped in thousands.
#pragma once

#include <QString>

namespace mapwright::sentences {

/// "1 submap", "12,480 submaps" from tr("%1 submaps", nullptr, formOf(count)); resources/mapwright_en.ts has
/// both forms. Not %n: that writes "12480", and %Ln as the system's language has it.
QString counted(const QString& translated, qint64 count);
/// The count for the n-form of tr.
int formOf(qint64 count);

}  // namespace mapwright::sentences
