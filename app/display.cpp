#include "app/display.h"

#include <cstdio>
#include <sys/mman.h>
#include <unistd.h>

#include <QByteArray>
#include <QGuiApplication>

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

/// Snapshots must not follow the user's font settings. Held in memory for as long as the program runs, so
/// that neither a full disk nor a folder that cannot be written changes a picture.
void pinFonts() {
  const int fd = ::memfd_create("mapwright fonts", 0);
  const QByteArray text(kFontConfig);
  if (fd < 0 || ::write(fd, text.constData(), std::size_t(text.size())) != text.size()) return;
  qputenv("FONTCONFIG_FILE", "/proc/self/fd/" + QByteArray::number(fd));
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
