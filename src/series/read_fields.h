// Reads numbers from the JSON of messages. Pure.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "series/field_path.h"

namespace mapwright::series {

/// Reads the wanted fields of messages, parsing each message once. One thread at a time.
class FieldReader {
 public:
  explicit FieldReader(std::vector<FieldPath> paths);
  ~FieldReader();
  FieldReader(FieldReader&&) noexcept;

  const std::vector<FieldPath>& paths() const { return paths_; }
  bool wants(std::string_view topic) const;
  /// By index of the path: its value in this message. Booleans are 0 and 1, numbers may be strings; null,
  /// infinite and "nan" are NaN. nullopt: of another topic, missing, not a number, or the message is not
  /// JSON. Valid until the next call.
  const std::vector<std::optional<double>>& read(std::string_view topic, std::string_view json);

 private:
  struct Parsing;
  std::vector<FieldPath> paths_;
  std::vector<std::optional<double>> values_;
  std::unique_ptr<Parsing> parsing_;
};

/// The fields of a message with numbers or booleans, in order: the first few of long arrays, at most `most`
/// in all, and not too deep. Empty: it is not a JSON object.
std::vector<FieldPath> numericFields(const std::string& topic, std::string_view json, std::size_t most = 300);

}  // namespace mapwright::series
