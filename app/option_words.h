// What is refused of every option, whatever it means: nothing, and numbers that are none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>

namespace CLI {
class App;
}

namespace mapwright::app {

/// What --help says, as CLI11 takes it.
inline std::string help(const QString& text) { return text.toStdString(); }

/// Every option of `app` and its subcommands that takes a value refuses an empty one; those that take a
/// number take decimal ones only ("nan", "inf", "0x10" and "5 m" are none).
void refuseOddWords(CLI::App& app);

/// "12", "-0.5", "1e-3".
bool isDecimal(const std::string& word);

/// "1,-0.5, 2": decimal numbers with commas between them, none further from 0 than 1e9; nullopt = something
/// else.
std::optional<std::vector<double>> numbersFrom(const std::string& typed);

}  // namespace mapwright::app
