// The addresses that the program's window understands.
#pragma once

#include "robot/aimdk/aimdk_address.h"
#include "robot/axbot/axbot_address.h"
#include "robot/files/file_address.h"

namespace mapwright::test {

inline robot::Addresses knownAddresses() {
  const auto demo = [](const QString& rest) -> robot::ParsedAddress {
    robot::Address address;
    address.text = QStringLiteral("demo:") + rest;
    return address;
  };
  return robot::Addresses({robot::axbot::addressScheme(),
                           robot::aimdk::addressScheme(),
                           {QStringLiteral("demo:"), QStringLiteral("demo:"), demo},
                           robot::files::addressScheme()});
}

}  // namespace mapwright::test
