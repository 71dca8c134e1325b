#include "app/option_words.h"

#include <charconv>
#include <cmath>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

namespace mapwright::app {
namespace {

class OptionWordsText {
  Q_DECLARE_TR_FUNCTIONS(OptionWords)
};

}  // namespace

bool isDecimal(const std::string& word) {
  const char* first = word.data();
  const char* const last = first + word.size();
  if (first != last && (*first == '+' || *first == '-')) ++first;
  if (first == last || !(*first == '.' || (*first >= '0' && *first <= '9'))) return false;  // "inf", "nan"
  double number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  return end == last && error != std::errc::invalid_argument;
}

std::optional<std::vector<double>> numbersFrom(const std::string& typed) {
  constexpr double kMost = 1e9;
  std::vector<double> numbers;
  for (const QString& part : QString::fromStdString(typed).split(QLatin1Char(','))) {
    const QString word = part.trimmed();
    const double number = word.toDouble();
    if (!isDecimal(word.toStdString()) || !(std::abs(number) <= kMost)) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

void refuseOddWords(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0) continue;  // a flag
    const std::string type = option->get_type_name();
    const bool number = type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT");
    option->check([number](const std::string& word) {
      if (word.empty()) return OptionWordsText::tr("the value is empty").toStdString();
      if (!number || isDecimal(word)) return std::string();
      return OptionWordsText::tr("\"%1\" is not a number").arg(QString::fromStdString(word)).toStdString();
    });
  }
  for (CLI::App* command : app.get_subcommands({})) refuseOddWords(*command);
}

}  // namespace mapwright::app
