// tests_fuzz TARGET PATH...: has the target read each file, and each file of a folder. What is found to be
// wrong ends the program; the last name said is that of the file.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "target.h"

namespace mapwright::fuzz {
namespace {

using Read = void (*)(Input);

std::map<std::string, Read>& targets() {
  static std::map<std::string, Read> all;
  return all;
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Registration::Registration(const char* name, void (*read)(Input)) { targets()[name] = read; }

}  // namespace mapwright::fuzz

int main(int argc, char** argv) {
  using namespace mapwright::fuzz;
  const auto target = argc > 2 ? targets().find(argv[1]) : targets().end();
  if (target == targets().end()) {
    std::fprintf(stderr, "tests_fuzz TARGET PATH...; the targets:\n");
    for (const auto& [name, read] : targets()) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  int count = 0;
  for (int i = 2; i < argc; ++i) {
    for (const auto& path : filesIn(argv[i])) {
      std::fprintf(stderr, "%s\n", path.c_str());
      std::ifstream file(path, std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      if (!file.good() && !file.eof()) return 1;
      target->second({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
      ++count;
    }
  }
  if (count == 0) std::fprintf(stderr, "There is nothing to read.\n");
  return count > 0 ? 0 : 1;
}
