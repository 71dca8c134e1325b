// Several test classes in one program; ctest runs each by its name. Each class stands in a namespace of its
// own, as they are compiled together.
#pragma once

#include <memory>

#include <QObject>

namespace mapwright::tests {

enum class Application { Nothing, Core, Widgets };

/// Makes a test class known to main() by the name of its source.
class Registration {
 public:
  using Make = std::unique_ptr<QObject> (*)();
  Registration(const char* name, Application application, Make make);
};

}  // namespace mapwright::tests

#define MAPWRIGHT_TEST(name, Class, application)                 \
  static const mapwright::tests::Registration registered_##name( \
      #name, mapwright::tests::Application::application,         \
      []() -> std::unique_ptr<QObject> { return std::make_unique<name::Class>(); });
