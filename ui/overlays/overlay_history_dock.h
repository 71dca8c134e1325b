// The dock "Overlay history": the versions that were read or saved here, what each changed, two of them
// compared on the map and in words, and one brought back. It needs no robot.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QDockWidget>

#include "geometry/rect.h"
#include "overlays/overlay_document.h"
#include "ui/overlays/overlay_history.h"
#include "ui/overlays/overlay_marks.h"

Q_DECLARE_METATYPE(mapwright::history::MapName)

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace mapwright::ui {

class OverlayHistoryDock : public QDockWidget {
  Q_OBJECT
 public:
  /// What is open for editing.
  struct Open {
    history::MapName map;
    std::function<overlays::OverlayDocument()> document;  // as it is here; as long as it is open
    bool editable = false;
  };
  /// All must outlive this.
  OverlayHistoryDock(OverlayHistory* history, const scene::MapScene* scene, OverlayMarks* marks,
                     QWidget* parent = nullptr);

  /// Asks what is open, when it is needed; nullopt: nothing is.
  void setOpen(std::function<std::optional<Open>()> open) { open_ = std::move(open); }
  /// Another map is open, or it can be edited now or no more.
  void openChanged();
  /// The versions of this map.
  void showMap(const history::MapName& map);

  QComboBox* mapChoice() const { return map_; }
  QTableWidget* table() const { return table_; }
  QComboBox* againstChoice() const { return against_; }
  QListWidget* changeList() const { return changes_; }
  QPushButton* restoreButton() const { return restore_; }
  QPushButton* saveAsButton() const { return save_as_; }
  QString statusShown() const;
  QString moreShown() const;
  QString troubleShown() const;

 Q_SIGNALS:
  void areaWanted(const mapwright::geometry::WorldRect& area);
  /// `called`: "version 3 of today 10:15".
  void restoreVersionWanted(const mapwright::overlays::OverlayDocument& version, const QString& called);
  void saveAsWanted(const QString& suggested, const std::string& text);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  /// A change between the two that are compared.
  struct Told {
    overlays::ChangeKind kind;
    QString sentence;
    std::vector<OverlayMark> marks;
  };
  void lookAnew();
  void onVersions(std::vector<history::KeptVersion> versions);
  void fillMaps();
  void fillTable();
  void summarize(std::size_t from);
  std::vector<std::size_t> rowsSelected() const;
  void compare();
  void showCompared(std::vector<Told> changes, const QString& about);
  void refresh();
  QString notBackReason() const;
  QString called(const history::KeptVersion& version) const;
  void fetch(std::function<void(const history::KeptVersion& version, std::string text)> then);
  void say(const QString& sentence);

  OverlayHistory* history_;
  const scene::MapScene* scene_;
  OverlayMarks* marks_;
  std::function<std::optional<Open>()> open_;
  std::vector<history::KeptVersion> all_, shown_;  // the newest first
  std::optional<history::MapName> wanted_;
  QComboBox *map_, *against_;
  QTableWidget* table_;
  QListWidget* changes_;
  QLabel *about_, *more_, *status_, *trouble_;
  QPushButton *restore_, *save_as_;
  std::vector<Told> told_;
  quint64 listed_ = 0, filled_ = 0, compared_ = 0;  // answers to earlier questions are ignored
  bool filling_ = false, read_ = false;
};

}  // namespace mapwright::ui
