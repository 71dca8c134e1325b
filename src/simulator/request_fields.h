// The data of a request: the members of a JSON object, or the parts of a form.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/value.h"

namespace mapwright::simulator {

class RequestFields {
 public:
  /// nullopt if the body is neither a JSON object nor, by its content type, a form.
  static std::optional<RequestFields> read(std::string_view content_type, std::string_view body);

  /// Present and not null.
  bool has(std::string_view key) const;
  std::optional<std::string> text(std::string_view key) const;
  std::optional<double> number(std::string_view key) const;  // finite
  std::optional<std::int64_t> integer(std::string_view key) const;
  std::optional<bool> flag(std::string_view key) const;
  std::optional<std::vector<double>> numbers(std::string_view key) const;  // only for a list of numbers

 private:
  static std::optional<RequestFields> readForm(std::string_view boundary, std::string_view body);
  const Value& find(std::string_view key) const;

  std::map<std::string, Value, std::less<>> values_;
  bool is_form_ = false;  // where numbers are texts
};

}  // namespace mapwright::simulator
