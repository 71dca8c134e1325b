// The arguments of a fault as texts.
#pragma once

#include <QStringList>

#include "fault/fault.h"

inline QStringList argumentsOf(const mapwright::Fault& fault) {
  QStringList texts;
  for (const mapwright::FaultArgument& argument : fault.arguments) {
    const auto* const text = std::get_if<std::string>(&argument);
    if (text) texts << QString::fromStdString(*text);
  }
  return texts;
}
