#include "app/window.h"

#include <cstdio>

#include <QApplication>
#include <QSettings>

#include "app/display.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/robot_factory.h"
#include "app/secret.h"
#include "app/snapshot.h"
#include "robot/files/picture_yamls.h"
#include "window/main_window.h"

namespace mapwright::app {
namespace {

session::Session::Options sessionOptions() {
  session::Session::Options options;
  options.sidecar_folder = gridCacheFolder();
  return options;
}

int showWindow(const QString& address, const QByteArray& secret) {
  QSettings settings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("mapwright"),
                     QStringLiteral("mapwright"));
  // The secret of the command line or the environment belongs to the address given beside it and to no other.
  window::MainWindow main_window({[&](const QString& to, const QByteArray& typed_secret) {
                                    const bool the_given_one = typed_secret.isEmpty() && to == address;
                                    return makeRobot(to, the_given_one ? secret : typed_secret,
                                                     DemoTime::Running);
                                  },
                                  settings,
                                  address,
                                  {},
                                  sessionOptions(),
                                  {},
                                  robot::files::yamlsNaming});
  main_window.show();
  return QApplication::exec();
}

}  // namespace

int window(const QString& address, const QString& secret_file, int& argc, char** argv) {
  const auto secret = readSecret(secret_file);
  if (!secret) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(secret.error())));
    return kUsage;
  }
  chooseWindowPlatform();
  QApplication application(argc, argv);
  if (!haveDisplay()) {
    std::fprintf(stderr,
                 "There is no display to open the window on. mapwright snapshot works without one.\n");
    return kUsage;
  }
  return showWindow(address, *secret);
}

int demo(const QString& query, int& argc, char** argv) {
  const QString address = query.isEmpty() ? QStringLiteral("demo:") : QStringLiteral("demo:?") + query;
  {
    chooseWindowPlatform();
    QApplication application(argc, argv);
    if (haveDisplay()) return showWindow(address, {});
  }
  const char picture[] = "mapwright-demo.png";
  std::fprintf(stderr, "There is no display to open the window on. Rendering %s instead.\n", picture);
  SnapshotWords words;
  words.robot = address.toStdString();
  words.output = picture;
  return snapshot(words, argc, argv);
}

}  // namespace mapwright::app
