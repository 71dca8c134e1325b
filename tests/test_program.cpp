#include "test_program.h"

#include <cstdio>
#include <map>
#include <string>

#include <QApplication>
#include <QTest>

namespace mapwright::tests {
namespace {

struct Known {
  Application application;
  Registration::Make make;
};

std::map<std::string, Known>& known() {
  static std::map<std::string, Known> all;
  return all;
}

int runWith(const Known& test, int argc, char** argv) {
  std::unique_ptr<QCoreApplication> application;
  if (test.application == Application::Core) application = std::make_unique<QCoreApplication>(argc, argv);
  if (test.application == Application::Widgets) {
    application = std::make_unique<QApplication>(argc, argv);
    application->setAttribute(Qt::AA_Use96Dpi, true);
  }
  const std::unique_ptr<QObject> object = test.make();
  return QTest::qExec(object.get(), argc, argv);
}

}  // namespace

Registration::Registration(const char* name, Application application, Make make) {
  known()[name] = {application, make};
}

}  // namespace mapwright::tests

/// tests_<room> test_<name> [what Qt Test takes]
int main(int argc, char** argv) {
  using namespace mapwright::tests;
  const auto test = argc > 1 ? known().find(argv[1]) : known().end();
  if (test == known().end()) {
    std::fprintf(stderr, "Name one of these tests:\n");
    for (const auto& [name, one] : known()) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  argv[1] = argv[0];
  return runWith(test->second, argc - 1, argv + 1);
}
