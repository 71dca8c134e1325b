#include "ui/window/support_text.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QScreen>
#include <QSysInfo>
#include <QThread>

#include "ui/window/made_of.h"

namespace mapwright::ui {
namespace {

constexpr qsizetype kMostProblems = 20;

}  // namespace

QStringList systemLines() {
  QStringList lines{
      QStringLiteral("%1, Linux %2, %3")
          .arg(QSysInfo::prettyProductName(), QSysInfo::kernelVersion(), QSysInfo::currentCpuArchitecture()),
      QCoreApplication::translate("window", "Processors: %1").arg(QThread::idealThreadCount()),
      QCoreApplication::translate("window", "Display: %1").arg(QGuiApplication::platformName())};
  for (const QScreen* screen : QGuiApplication::screens()) {
    const QSize size = screen->size();
    lines << QCoreApplication::translate("window", "Screen: %1 × %2, scale %3, %4 Hz")
                 .arg(size.width())
                 .arg(size.height())
                 .arg(screen->devicePixelRatio())
                 .arg(screen->refreshRate(), 0, 'f', 0);
  }
  return lines;
}

QString supportText(const Support& support, const QStringList& system, const Privacy& privacy) {
  QStringList parts{versionText(), system.join(QLatin1Char('\n'))};
  if (!support.robot.isEmpty()) parts << support.robot.join(QLatin1Char('\n'));
  parts << support.diagnostics;
  if (!support.problems.isEmpty()) {
    const QStringList last =
        support.problems.mid(qMax<qsizetype>(0, support.problems.size() - kMostProblems));
    parts << QCoreApplication::translate("window", "Problems (the last %1 of %2)")
                     .arg(last.size())
                     .arg(support.problems.size()) +
                 QLatin1Char('\n') + last.join(QLatin1Char('\n'));
  }
  return withoutPrivate(parts.join(QStringLiteral("\n\n")), privacy) + QStringLiteral("\n\n") +
         leftOutSentence() + QLatin1Char('\n');
}

QString leftOutSentence() {
  return QCoreApplication::translate("window",
                                     "Left out: addresses and names of robots (robot-1, robot-2 …), secrets, "
                                     "home folders, the names of user and computer. Names of maps, files and "
                                     "topics are in it, and names of one or two letters.");
}

}  // namespace mapwright::ui
