// Why a command ends without what it was asked for.
#pragma once

#include <QString>
#include <tl/expected.hpp>

#include "app/exit_code.h"

namespace mapwright::app {

/// A sentence and the exit code that it comes with.
struct CommandFailure {
  int exit_code = 0;
  QString sentence;
};
template <typename T>
using CommandResult = tl::expected<T, CommandFailure>;

/// What was typed cannot be done.
inline tl::unexpected<CommandFailure> wrong(const QString& sentence) {
  return tl::make_unexpected(CommandFailure{kUsage, sentence});
}

}  // namespace mapwright::app
