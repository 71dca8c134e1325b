// Why a command could not do its job.
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

/// The options given make no sense together or on their own.
inline tl::unexpected<CommandFailure> wrong(const QString& sentence) {
  return tl::make_unexpected(CommandFailure{kUsage, sentence});
}

}  // namespace mapwright::app
