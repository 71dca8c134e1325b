// Formats JSON for reading without parsing it: numbers and the order of keys stay as sent.
#pragma once

#include <QByteArray>
#include <QString>

namespace mapwright::ui {

/// Indented by two spaces; short lists stay on one line; strings longer than `longest_string` are truncated
/// with a note of their length. Stops at `limit` characters, with a note. Text that is not JSON is unchanged,
/// up to the limit.
QString prettyJson(const QByteArray& text, qsizetype limit = 32'768, qsizetype longest_string = 400);

}  // namespace mapwright::ui
