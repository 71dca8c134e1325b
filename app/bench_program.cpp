#include "app/bench_program.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "words/plain.h"

namespace mapwright::app {
namespace {

class BenchProgramText {
  Q_DECLARE_TR_FUNCTIONS(BenchProgram)
};

}  // namespace

int bench(const std::vector<std::string>& arguments) {
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  std::vector<std::string> words{(self.parent_path() / "mapwright-bench").string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  const int error = errno;
  const QString program = QString::fromStdString(words::plainLine(std::string_view(words[0])));
  const QString why = error == ENOENT
                          ? BenchProgramText::tr(
                                "The benchmarks are a separate program that is built on demand, and there is "
                                "no %1. Run \"./run bench\" in mapwright's source tree.")
                                .arg(program)
                          : BenchProgramText::tr("%1 cannot be started: %2.")
                                .arg(program, QString::fromLocal8Bit(std::strerror(error)));
  std::fprintf(stderr, "%s\n", qUtf8Printable(why));
  return kUsage;
}

}  // namespace mapwright::app
