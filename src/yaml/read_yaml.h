// A YAML text of unknown origin, read by yaml-cpp within bounds: of its length, its depth, and its size once
// all aliases are followed (so that whoever walks over the nodes ends). Pure; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <yaml-cpp/yaml.h>

#include <tl/expected.hpp>

namespace mapwright::yaml {

struct Limits {
  std::size_t most_bytes = std::size_t(4) << 20;
  std::size_t most_nodes = 1'000'000;  // aliases count as what they stand for
  std::size_t most_depth = 100;
};

/// Why a text is refused, and where: from 1; 0: unknown.
struct Broken {
  enum class Code { TooLong, TooMuch, TooDeep, NotYaml } code = Code::NotYaml;
  int line = 0, column = 0;
  std::string detail;  // of NotYaml, in English; untrusted
};

struct Document {
  YAML::Node root;                 // of the first document; null if there is none
  std::optional<YAML::Mark> next;  // where another document begins that is not empty
};

tl::expected<Document, Broken> readYaml(const std::string& text, const Limits& limits = {});

}  // namespace mapwright::yaml
