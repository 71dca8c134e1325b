#include "ui/window/shortcut_sheet.h"

#include <QAbstractItemView>
#include <QClipboard>
#include <QCoreApplication>
#include <QDialog>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/window/made_of.h"

namespace mapwright::ui {

namespace {

struct Line {
  QString what, keys;
};
struct Group {
  QString title;
  QList<Line> lines;
};

QList<Group> groupsOf(const Actions& actions) {
  QList<Group> groups;
  groups << Group{QCoreApplication::translate("window", "Mouse and touchpad"),
                  {{QCoreApplication::translate("window", "Pan"),
                    QCoreApplication::translate("window", "drag, middle drag, Space+drag")},
                   {QCoreApplication::translate("window", "Pan (touchpad)"),
                    QCoreApplication::translate("window", "two fingers")},
                   {QCoreApplication::translate("window", "Pan"),
                    QCoreApplication::translate("window", "arrows, Shift = faster")},
                   {QCoreApplication::translate("window", "Zoom at the cursor"),
                    QCoreApplication::translate("window", "wheel, pinch")},
                   {QCoreApplication::translate("window", "Zoom finely"),
                    QCoreApplication::translate("window", "Ctrl+wheel")},
                   {QCoreApplication::translate("window", "Rotate the view"),
                    QCoreApplication::translate("window", "Shift+wheel")},
                   {QCoreApplication::translate("window", "Centre and zoom in"),
                    QCoreApplication::translate("window", "double click")},
                   {QCoreApplication::translate("window", "Leave the tool or dialog"),
                    QCoreApplication::translate("window", "Esc")}}};
  for (const Actions::Entry& entry : actions.entries()) {
    const QString keys = shortcutsText(*entry.action);
    if (keys.isEmpty()) continue;
    if (groups.last().title != entry.menu) {
      auto known =
          std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.title == entry.menu; });
      if (known != groups.end()) {
        known->lines << Line{nameAlone(entry), keys};
        continue;
      }
      groups << Group{entry.menu, {}};
    }
    groups.last().lines << Line{nameAlone(entry), keys};
  }
  return groups;
}

QWidget* groupBox(const Group& group, QWidget* parent) {
  auto* box = new QWidget(parent);
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 8);
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(0);
  auto* title = new QLabel(group.title, box);
  makeHeading(*title);
  grid->addWidget(title, 0, 0, 1, 2);
  int row = 1;
  for (const Line& line : group.lines) {
    auto* what = new PlainLabel(line.what, box);
    auto* keys = new PlainLabel(line.keys, box);
    keys->setSecondary(true);
    keys->setAlignment(Qt::AlignRight);
    grid->addWidget(what, row, 0);
    grid->addWidget(keys, row++, 1);
  }
  grid->setColumnStretch(0, 1);
  return box;
}

QDialog* closable(const QString& title, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  return dialog;
}

QHBoxLayout* closeRow(QDialog* dialog) {
  auto* close = new QPushButton(QCoreApplication::translate("window", "Close"), dialog);
  close->setObjectName(QStringLiteral("secondary"));
  close->setDefault(true);
  QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::accept);
  return rowOf({LayoutItem::rest(), close});
}

}  // namespace

QDialog* makeShortcutSheet(const Actions& actions, QWidget* parent) {
  QDialog* dialog = closable(QCoreApplication::translate("window", "Keys and gestures"), parent);
  auto* page = new QWidget(dialog);
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(16, 16, 16, 0);
  columns->setSpacing(40);
  auto* left = new QVBoxLayout;
  auto* right = new QVBoxLayout;
  columns->addLayout(left, 1);
  columns->addLayout(right, 1);
  qsizetype left_lines = 0, right_lines = 0;
  for (const Group& group : groupsOf(actions)) {
    QVBoxLayout* shorter = left_lines <= right_lines ? left : right;
    (shorter == left ? left_lines : right_lines) += group.lines.size() + 2;
    shorter->addWidget(groupBox(group, page));
  }
  left->addStretch();
  right->addStretch();
  auto* scroll = new QScrollArea(dialog);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(page);
  auto* column = new QVBoxLayout(dialog);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scroll, 1);
  QHBoxLayout* row = closeRow(dialog);
  row->setContentsMargins(16, 4, 16, 12);
  column->addLayout(row);
  const QSize wanted = page->sizeHint() + QSize(24, 64);
  dialog->resize(qMax(780, wanted.width()), qMin(wanted.height(), parent ? parent->height() - 40 : 640));
  return dialog;
}

QDialog* makeAboutBox(QWidget* parent) {
  QDialog* dialog = closable(QCoreApplication::translate("window", "About mapwright"), parent);
  auto* picture = new QLabel(dialog);
  picture->setPixmap(
      QIcon(QStringLiteral(":/mapwright.svg")).pixmap(QSize(64, 64), dialog->devicePixelRatioF()));
  auto* name = new QLabel(QStringLiteral("mapwright %1").arg(QLatin1String(MAPWRIGHT_VERSION)), dialog);
  makeHeading(*name, 1.5);
  auto* text =
      textLabel(QCoreApplication::translate("window",
                                            "Shows what a mobile robot's SLAM sees, submap by submap, live.\n"
                                            "Licensed under the Apache License 2.0."),
                dialog);
  const QString commit =
      builtCommit().isEmpty() ? QCoreApplication::translate("window", "unknown") : builtCommit();
  auto* built = textLabel(QCoreApplication::translate("window", "Commit %1\nQt %2, compiled against %3")
                              .arg(commit, runningQt(), compiledQt()),
                          dialog);
  auto* used = new QLabel(QCoreApplication::translate("window", "Built with"), dialog);
  makeHeading(*used);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(0);
  int row = 0;
  for (const Library& library : libraries()) {
    auto* licence = new PlainLabel(library.licence, dialog);
    licence->setSecondary(true);
    grid->addWidget(new PlainLabel(library.name, dialog), row, 0);
    grid->addWidget(new PlainLabel(library.version, dialog), row, 1);
    grid->addWidget(licence, row++, 2);
  }
  grid->setColumnStretch(2, 1);
  QHBoxLayout* buttons = closeRow(dialog);
  auto* copy = new QPushButton(QCoreApplication::translate("window", "&Copy"), dialog);
  copy->setObjectName(QStringLiteral("secondary"));
  copy->setAutoDefault(false);
  copy->setToolTip(QCoreApplication::translate("window", "Version, commit and libraries as a text"));
  QObject::connect(copy, &QPushButton::clicked, dialog,
                   [] { QGuiApplication::clipboard()->setText(versionText()); });
  buttons->insertWidget(1, copy);
  auto* words = columnOf({name, text, built, LayoutItem::gap(4), used, grid, LayoutItem::gap(8), buttons}, 8);
  dialog->setLayout(rowOf({{picture, 0, Qt::AlignTop}, {words, 1}}, 20, QMargins(20, 20, 20, 16)));
  dialog->setMinimumWidth(510);
  return dialog;
}

}  // namespace mapwright::ui
