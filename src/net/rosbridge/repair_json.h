// Makes the nearly-JSON of some servers readable.
#pragma once

#include <QByteArray>

namespace mapwright::net::rosbridge {

/// The text with NaN, Infinity, -Infinity and numbers that no type holds replaced by null, and, within
/// strings, bytes that are no UTF-8 and halves of surrogate pairs by U+FFFD. What else is wrong stays as it
/// is.
QByteArray repairJson(const QByteArray& text);

}  // namespace mapwright::net::rosbridge
