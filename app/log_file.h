// The file of --log-file: it grows to a limit, then older ones are numbered and the oldest goes.
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <QString>

namespace mapwright::app {

class LogFile {
 public:
  struct Limits {
    std::size_t bytes = 2'000'000;
    int files = 5;  // FILE, FILE.1 … FILE.4
  };
  LogFile() = default;
  explicit LogFile(Limits limits) : limits_(limits) {}
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  /// Goes on behind what another run wrote. A sentence: there is no log in it. Other files are left alone,
  /// and so is a log that another mapwright is writing.
  std::optional<QString> open(const std::string& path);
  /// One line, from any thread. A sentence, once, when it cannot be written: lines are lost until there is
  /// room again.
  std::optional<QString> write(std::string_view line);

 private:
  bool turn();  // errno says why not

  Limits limits_;
  std::mutex mutex_;
  std::string path_;
  int file_ = -1;
  std::size_t bytes_ = 0;
  bool cut_ = false;  // its last line is not whole
  bool said_ = false;
};

}  // namespace mapwright::app
