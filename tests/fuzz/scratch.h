// A file for readers that take no bytes, only a path.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include "target.h"

namespace mapwright::fuzz {

class ScratchFolder {
 public:
  ScratchFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("mapwright-fuzz-" + std::to_string(::getpid()) + "-XXXXXX")) {
    std::string name = path_.string();
    MUST(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code failed;
    std::filesystem::remove_all(path_, failed);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path() const { return path_.string(); }
  std::string write(const std::string& name, Input bytes) const {
    return writeTo((path_ / name).string(), bytes);
  }
  static std::string writeTo(const std::string& path, Input bytes) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    return path;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace mapwright::fuzz
