#include "app/display.h"

#include <cstdio>
#include <unistd.h>

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QStandardPaths>

#include "disk/read_file.h"
#include "disk/written_file.h"

namespace mapwright::app {
namespace {

// Parameters behind the colon mark our own fallback, so that a user's plain "offscreen" still opens the
// window there.
constexpr char kFallback[] = "offscreen:";

constexpr char kFontConfig[] = R"(<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <dir>/usr/share/fonts</dir>
  <cachedir prefix="xdg">fontconfig</cachedir>
  <match target="font">
    <edit name="antialias" mode="assign"><bool>true</bool></edit>
    <edit name="hinting" mode="assign"><bool>false</bool></edit>
    <edit name="rgba" mode="assign"><const>none</const></edit>
  </match>
</fontconfig>
)";

/// Snapshots must not follow the user's font settings. Neither a full disk nor a cache that cannot be written
/// may change a picture: then the file goes where there is room. (Fontconfig wants a file with a path.)
void pinFonts() {
  const QString user = QString::number(::getuid());
  for (const QString& folder :
       {QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + QStringLiteral("/mapwright"),
        QStringLiteral("/dev/shm/mapwright-") + user,
        QDir::tempPath() + QStringLiteral("/mapwright-") + user}) {
    const QString path = folder + QStringLiteral("/snapshot-fonts.conf");
    const auto present = disk::readFile(path.toStdString(), sizeof(kFontConfig));
    const bool there = present && *present == kFontConfig;
    if (!there && (!QDir().mkpath(folder) || disk::writeFile(path.toStdString(), kFontConfig))) continue;
    qputenv("FONTCONFIG_FILE", QFile::encodeName(path));
    return;
  }
  std::fprintf(stderr, "Fonts cannot be pinned: no folder can be written. Labels may look different.\n");
}

/// Qt's own remarks (a missing XDG_RUNTIME_DIR, say) are no business of whoever reads our one line of error.
void keepQtQuiet(QtMsgType type, const QMessageLogContext&, const QString& message) {
  const bool wanted =
      type == QtCriticalMsg || type == QtFatalMsg || qEnvironmentVariableIsSet("MAPWRIGHT_DEBUG");
  if (wanted) std::fprintf(stderr, "%s\n", qUtf8Printable(message));
}

}  // namespace

void chooseWindowPlatform() {
  qInstallMessageHandler(keepQtQuiet);
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) return;
  QByteArray platforms;
  if (!qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) platforms += "wayland;";
  if (!qEnvironmentVariableIsEmpty("DISPLAY")) platforms += "xcb;";
  qputenv("QT_QPA_PLATFORM", platforms + kFallback);
}

void chooseOffscreenPlatform() {
  qInstallMessageHandler(keepQtQuiet);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  pinFonts();
}

bool haveDisplay() {
  return QGuiApplication::platformName() != QLatin1String("offscreen") ||
         !qgetenv("QT_QPA_PLATFORM").endsWith(kFallback);
}

}  // namespace mapwright::app
