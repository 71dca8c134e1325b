// Why a command ends without what it was asked for.
#pragma once

#include <QString>
#include <tl/expected.hpp>

namespace mapwright::app {

/// A sentence and the exit code that it comes with.
struct CommandFailure {
  int exit_code = 0;
  QString sentence;
};
template <typename T>
using CommandResult = tl::expected<T, CommandFailure>;

}  // namespace mapwright::app
