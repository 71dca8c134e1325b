// Repairs the almost valid JSON of some servers.
#pragma once

#include <QByteArray>

namespace mapwright::net::rosbridge {

/// The text with NaN, Infinity, -Infinity and numbers out of range replaced by null, and, within strings,
/// invalid UTF-8 and unpaired surrogates by U+FFFD. Other errors stay.
QByteArray repairJson(const QByteArray& text);

}  // namespace mapwright::net::rosbridge
