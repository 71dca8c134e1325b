#include "app/window.h"

#include <cstdio>

#include <QApplication>
#include <QLoggingCategory>

#include "app/display.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/robot_factory.h"
#include "app/settings_file.h"
#include "app/snapshot.h"
#include "robot/address.h"
#include "robot/files/picture_yamls.h"
#include "window/dialogs/trusted_certificates.h"
#include "window/main_window.h"

namespace mapwright::app {
namespace {

session::Session::Options sessionOptions() {
  session::Session::Options options;
  options.sidecar_folder = gridCacheFolder();
  return options;
}

int showWindow(const QString& address, const RobotAccess& known) {
  const std::unique_ptr<QSettings> settings = openSettings();
  window::MainWindow main_window({[&](const QString& to, const QByteArray& typed_secret) {
                                    Access access = known.forAddress(to);
                                    if (!typed_secret.isEmpty()) access.secret = typed_secret;
                                    if (const auto parsed = robot::parseAddress(to)) {
                                      access.trust.pinned_sha256 = net::fingerprintFrom(
                                          window::TrustedCertificates(*settings).of(robot::hostOf(*parsed)));
                                    }
                                    return makeRobot(to, access, DemoTime::Running);
                                  },
                                  *settings,
                                  address,
                                  sessionOptions(),
                                  {},
                                  robot::files::yamlsNaming});
  main_window.show();
  const int exit_code = QApplication::exec();
  settings->sync();
  if (settings->status() != QSettings::NoError) {
    std::fprintf(stderr, "The window's layout cannot be kept: %s cannot be written.\n",
                 qUtf8Printable(settings->fileName()));
  }
  return exit_code;
}

}  // namespace

int window(const QString& address, const AccessWords& words, int& argc, char** argv) {
  // Reading certificates before there is an application makes Qt remark on itself.
  QLoggingCategory::setFilterRules(QStringLiteral("qt.core.qobject.connect=false"));
  const auto access = RobotAccess::read(words, address);
  QLoggingCategory::setFilterRules({});
  if (!access) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(access.error())));
    return kUsage;
  }
  chooseWindowPlatform();
  QApplication application(argc, argv);
  if (!haveDisplay()) {
    std::fprintf(stderr,
                 "There is no display to open the window on. mapwright snapshot works without one.\n");
    return kUsage;
  }
  return showWindow(address, *access);
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
