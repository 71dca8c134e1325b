// A file that is written beside its place and moved there once it is whole. One thread.
#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

namespace mapwright::raster {

class AsideFile {
 public:
  explicit AsideFile(std::string path);
  /// Not placed: removed.
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;
  void write(const void* bytes, std::size_t count);
  void write(const std::string& text) { write(text.data(), text.size()); }
  bool good() const { return file_ != nullptr && error_ == 0; }
  /// nullopt = the file is in its place; else a sentence.
  std::optional<std::string> place();

 private:
  std::string path_, aside_;
  std::FILE* file_ = nullptr;
  int error_ = 0;
};

}  // namespace mapwright::raster
