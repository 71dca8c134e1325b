#include "app/display.h"

#include <cstdio>

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFont>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QLocale>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/command_text.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "ui/scene/label_font.h"

static void initFonts() { Q_INIT_RESOURCE(fonts); }

namespace mapwright::app {
namespace {

// Parameters after the colon mark our own fallback, so that a user's plain "offscreen" still opens the window
// there.
constexpr char kFallback[] = "offscreen:";

// Whatever else is installed: beside the font that the program brings along only those of Noto, in the
// versions of Debian 12 (fonts-noto-cjk, fonts-noto-color-emoji). One family of Noto has all of Chinese,
// Japanese and Korean; of several the language of the user would choose. Folders of bitmap and printer fonts
// are not even looked into: unpacking those took most of the time of a first command.
constexpr char kFontConfig[] = R"(<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <dir>/usr/share/fonts</dir>
  <cachedir prefix="xdg">fontconfig</cachedir>
  <selectfont>
    <rejectfont>
      <glob>/usr/share/fonts/X11*</glob>
      <glob>/usr/share/fonts/?ype1*</glob>
      <glob>/usr/share/fonts/c?ap*</glob>
    </rejectfont>
    <rejectfont><pattern><patelt name="scalable"><bool>true</bool></patelt></pattern></rejectfont>
    <rejectfont><pattern><patelt name="scalable"><bool>false</bool></patelt></pattern></rejectfont>
    <acceptfont><pattern>
      <patelt name="family"><string>Noto Sans CJK SC</string></patelt>
      <patelt name="fontversion"><int>131334</int></patelt>
    </pattern></acceptfont>
    <acceptfont><pattern>
      <patelt name="family"><string>Noto Color Emoji</string></patelt>
      <patelt name="fontversion"><int>133825</int></patelt>
    </pattern></acceptfont>
  </selectfont>
  <match target="font">
    <edit name="antialias" mode="assign"><bool>true</bool></edit>
    <edit name="hinting" mode="assign"><bool>false</bool></edit>
    <edit name="rgba" mode="assign"><const>none</const></edit>
  </match>
</fontconfig>
)";

/// True when fontconfig will read it there.
bool pinFontsIn(const QString& folder) {
  const QString path = folder + QStringLiteral("/snapshot-fonts.conf");
  const auto present = disk::readFile(path.toStdString(), sizeof(kFontConfig));
  const bool there = present && *present == kFontConfig;
  if (!there && (!QDir().mkpath(folder) || disk::writeFile(path.toStdString(), kFontConfig))) return false;
  qputenv("FONTCONFIG_FILE", QFile::encodeName(path));
  return true;
}

/// Snapshots must not follow the user's font settings. Neither a full disk nor a cache that cannot be written
/// may change a picture: then the file goes where there is room, into a folder that is made for this run and
/// nobody else can have laid out. (Fontconfig wants a file with a path.)
std::unique_ptr<QTemporaryDir> pinFonts() {
  if (pinFontsIn(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
                 QStringLiteral("/mapwright")))
    return nullptr;
  for (const QString& parent : {QStringLiteral("/dev/shm"), QDir::tempPath()}) {
    auto folder = std::make_unique<QTemporaryDir>(parent + QStringLiteral("/mapwright-XXXXXX"));
    if (folder->isValid() && pinFontsIn(folder->path())) return folder;
  }
  say(Text::tr("No folder is writable, so the built-in fonts cannot be used. Labels may look different."));
  return nullptr;
}

std::unique_ptr<QTemporaryDir> chooseOffscreen() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qunsetenv("QT_FONT_DPI");  // below 96 letters would get smaller
  return pinFonts();
}

}  // namespace

void chooseWindowPlatform() {
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) return;
  QByteArray platforms;
  if (!qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) platforms += "wayland;";
  if (!qEnvironmentVariableIsEmpty("DISPLAY")) platforms += "xcb;";
  qputenv("QT_QPA_PLATFORM", platforms + kFallback);
}

OffscreenApplication::OffscreenApplication(int& argc, char** argv)
    : PinnedFonts{chooseOffscreen()}, QApplication(argc, argv) {
  addLabelFont();
}

bool addLettersOf(const QString& language) {
  if (QLocale(language).script() != QLocale::SimplifiedHanScript) return true;
  const QStringList there = QFontDatabase::families(QFontDatabase::SimplifiedChinese);
  if (there.isEmpty()) return false;
  QString chosen = there.first();
  for (const char* const family : {"Noto Sans CJK SC", "Noto Sans SC", "Source Han Sans SC",
                                   "Source Han Sans CN", "WenQuanYi Micro Hei", "WenQuanYi Zen Hei"}) {
    if (!there.contains(QLatin1String(family))) continue;
    chosen = QLatin1String(family);
    break;
  }
  for (const QString& family : {QApplication::font().family(), QStringLiteral("DejaVu Sans")})
    QFont::insertSubstitution(family, chosen);
  return true;
}

void addLabelFont() {
  initFonts();
  QFontDatabase::addApplicationFont(QString::fromLatin1(ui::scene::kLabelFontFile));
}

bool haveDisplay() {
  return QGuiApplication::platformName() != QLatin1String("offscreen") ||
         !qgetenv("QT_QPA_PLATFORM").endsWith(kFallback);
}

}  // namespace mapwright::app
