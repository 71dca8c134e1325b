// Numbers out of the JSON of messages. Pure.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "series/field_path.h"

namespace mapwright::series {

/// Reads the wanted fields of messages: one parse of a message for all of them. One thread at a time.
class FieldReader {
 public:
  explicit FieldReader(std::vector<FieldPath> paths);
  ~FieldReader();
  FieldReader(FieldReader&&) noexcept;

  const std::vector<FieldPath>& paths() const { return paths_; }
  bool wants(std::string_view topic) const;
  /// By the place of the path: its value in this message. Booleans are 0 and 1, numbers may stand in strings;
  /// null, and what is infinite or "nan", is NaN. nullopt: of another topic, not there, no number, or the
  /// message is no JSON. Valid until the next call.
  const std::vector<std::optional<double>>& read(std::string_view topic, std::string_view json);

 private:
  struct Parsing;
  std::vector<FieldPath> paths_;
  std::vector<std::optional<double>> values_;
  std::unique_ptr<Parsing> parsing_;
};

/// The fields of a message that hold numbers or booleans, in its order: of long arrays the first few, no more
/// than `most` in all, and none that lie too deep. Empty: it is no JSON object.
std::vector<FieldPath> numericFields(const std::string& topic, std::string_view json, std::size_t most = 300);

}  // namespace mapwright::series
