// Checks that apply to every option: no empty values, and valid numbers.
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

/// Makes every option of `app` and its subcommands refuse empty values, and numeric ones anything but decimal
/// numbers ("nan", "inf", "0x10" and "5 m" are refused).
void refuseOddWords(CLI::App& app);

/// "12", "-0.5", "1e-3".
bool isDecimal(const std::string& word);

/// "1,-0.5, 2": decimal numbers separated by commas, absolute values up to 1e9; nullopt = anything else.
std::optional<std::vector<double>> numbersFrom(const std::string& typed);

}  // namespace mapwright::app
