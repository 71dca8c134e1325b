#include "app/window.h"

#include <cstdio>

#include <QApplication>
#include <QCoreApplication>

#include "app/display.h"
#include "app/exit_code.h"
#include "app/fetch_ahead.h"
#include "app/one_line.h"
#include "app/robot_factory.h"
#include "app/settings_file.h"
#include "app/snapshot.h"
#include "replay/replay_robot.h"
#include "robot/address.h"
#include "robot/files/local_maps.h"
#include "robot/recorded/recorded_robot.h"
#include "robot/second_server.h"
#include "ui/robot/recent_robots.h"
#include "ui/view/replay_state.h"
#include "window/main_window.h"
#include "window/work_settings.h"
#include "work/workers.h"

namespace mapwright::app {
namespace {

class WindowCommandText {
  Q_DECLARE_TR_FUNCTIONS(WindowCommand)
};

session::Session::Options sessionOptions() {
  session::Session::Options options;
  options.scheduler.max_concurrent = kFetchAhead;
  options.sidecar_folder = gridCacheFolder();
  return options;
}

edit::EditOptions editOptions() {
  edit::EditOptions options;
  options.drafts_folder = draftsFolder();
  return options;
}

int showWindow(const QString& address, const RobotAccess& known) {
  const std::unique_ptr<QSettings> settings = openSettings();
  const robot::Addresses addresses = knownAddresses();
  const window::KeptWorkSettings kept = window::workSettingsIn(*settings);
  for (const QString& sentence : kept.nonsense)
    std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(sentence)));
  window::MainWindow::Dependencies wanted{
      [&](const QString& to, const QByteArray& typed_secret) {
        Access access = known.forAddress(to);
        if (!typed_secret.isEmpty()) access.secret = typed_secret;
        const window::TrustedCertificates trusted(*settings);
        const auto parsed = addresses.parse(to);
        if (parsed) access.trust.pinned_sha256 = net::fingerprintFrom(trusted.of(robot::hostOf(*parsed)));
        auto made = makeRobot(to, access, DemoTime::Running);
        robot::SecondServer* const second = made ? robot::secondServerOf(**made) : nullptr;
        const QString beside = second ? trusted.of(second->hostBeside()) : QString();
        if (!beside.isEmpty()) second->trustBeside(beside);
        // A recording is viewed by playing it.
        if (made && parsed && !parsed->path.isEmpty() && robot::recorded::isRecording(parsed->path))
          *made = std::make_unique<replay::ReplayRobot>(
              std::move(*made), robot::recorded::bagNameOf(parsed->path), window::followedReading());
        return made;
      },
      *settings, address};
  wanted.session = sessionOptions();
  wanted.yamls_naming = robot::files::yamlsNaming;
  wanted.edit = editOptions();
  wanted.addresses = addresses;
  wanted.workers = std::make_shared<work::Workers>(kept.settings.threads);
  wanted.budgets = kept.settings.budgets();
  window::MainWindow main_window(std::move(wanted));
  main_window.show();
  const int exit_code = QApplication::exec();
  settings->sync();
  if (settings->status() != QSettings::NoError) {
    std::fprintf(
        stderr, "%s\n",
        qUtf8Printable(WindowCommandText::tr("The window layout cannot be saved: %1 is not writable.")
                           .arg(settings->fileName())));
  }
  return exit_code;
}

}  // namespace

int window(const QString& address, const AccessWords& words, int& argc, char** argv) {
  chooseWindowPlatform();
  QApplication application(argc, argv);
  const auto access = RobotAccess::read(words, address);
  if (!access) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(access.error())));
    return kUsage;
  }
  if (!haveDisplay()) {
    std::fprintf(stderr, "%s\n",
                 qUtf8Printable(WindowCommandText::tr(
                     "There is no display to open the window on. mapwright snapshot works without one.")));
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
  const QString picture = QStringLiteral("mapwright-demo.png");
  std::fprintf(
      stderr, "%s\n",
      qUtf8Printable(WindowCommandText::tr("There is no display to open the window on. Rendering %1 instead.")
                         .arg(picture)));
  SnapshotWords words;
  words.robot = address.toStdString();
  words.output = picture.toStdString();
  return snapshot(words, argc, argv);
}

}  // namespace mapwright::app
