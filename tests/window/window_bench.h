// A whole window on a fake robot, for tests.
#pragma once

#include <functional>
#include <memory>

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "fake_robot.h"
#include "known_addresses.h"
#include "ui/slam/inspector_dock.h"
#include "ui/view/map_view.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace mapwright::test {

using ui::MainWindow;

inline const QString kAddress = QStringLiteral("axbot+http://192.0.2.7:8090");

struct Bench {
  Bench() : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {}

  MainWindow& open(const QSize& size = {1366, 768}) {
    window.reset();
    MainWindow::Dependencies wanted{
        [this](const QString& address,
               const QByteArray& typed) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          if (address == QLatin1String("bad")) {
            return tl::unexpected(QStringLiteral("This is no address."));
          }
          auto made = std::make_unique<FakeRobot>(address);
          secret = typed;
          robot = made.get();
          if (prepare) prepare(*made);
          return std::unique_ptr<robot::Robot>(std::move(made));
        },
        settings};
    wanted.yamls_naming = yamls_naming;
    wanted.edit = edit;
    wanted.workers = workers;
    wanted.budgets = budgets;
    wanted.addresses = knownAddresses();
    wanted.keys = keys;
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(size);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
    return *window;
  }
  QAction* action(const char* id) { return window->actionList().find(QLatin1String(id)); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window->view(), key, modifiers);
  }
  QModelIndex row(map::SubmapId id, int column = 0) {
    ui::InspectorDock* dock = ui::part<ui::InspectorDock>(*window);
    return dock->filterModel()->mapFromSource(dock->model()->indexOf(id)).siblingAtColumn(column);
  }
  /// A robot with stored maps 1 (current), 2 and a mapping 7.
  void offerMaps() {
    prepare = [](FakeRobot& made) {
      made.has_catalogue = true;
      made.maps.entries = {catalogued("1", "Ground floor"), catalogued("2", "<b>Attic</b>"),
                           catalogued("7", "Survey")};
      made.maps.entries[0].is_current = true;
      made.maps.entries[2].key.kind = map::MapKind::Mapping;
    };
  }
  /// Two trajectories, the second far to the right; all pictures in.
  void load() {
    robot->list({entry(0, 0, 1, 0, 0), entry(0, 1, 1, 5, 0), entry(1, 0, 3, 40, 0)});
    QTRY_COMPARE(window->session()->counts().shown, 3);
    QTRY_VERIFY(row({1, 0}).isValid());
  }

  QTemporaryDir folder;
  QSettings settings;
  std::unique_ptr<MainWindow> window;
  FakeRobot* robot = nullptr;
  QByteArray secret;  // that of the last connection
  std::function<void(FakeRobot&)> prepare;
  std::function<QStringList(const QString&)> yamls_naming;
  edit::EditOptions edit;
  std::shared_ptr<work::Workers> workers = std::make_shared<work::Workers>();
  work::Budgets budgets = work::budgetsFrom();
  keyring::KeyRing* keys = nullptr;
};

}  // namespace mapwright::test
