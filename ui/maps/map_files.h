// Map files and recordings that can be opened, their addresses, and the position of a picture: from the
// map.yaml in its folder, or by asking.
#pragma once

#include <functional>
#include <optional>

#include <QDialog>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QUrl>

#include "geometry/pose.h"
#include "work/workers.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::ui {

/// The position of a plain picture in the world.
struct PicturePlacement {
  double resolution_m = 0.05;  // metres per cell
  geometry::Pose2 origin;      // of the lower-left corner
};

bool isMapYaml(const QString& path);
bool isBarePicture(const QString& path);
/// By its extension: MCAP, or ROS 1 bag.
bool isRecordingFile(const QString& path);
/// By its extension: GeoJSON.
bool isOverlayFile(const QString& path);
/// By its extension: a state file of Cartographer.
bool isStateFile(const QString& path);
/// "file:/maps/a.yaml", "file:/maps/a.png?resolution=0.05&origin=-1,2,0".
QString fileAddress(const QString& path, const std::optional<PicturePlacement>& placement = {});
/// The one dropped file that can be opened: a map.yaml, a recording, a state file, a picture or a folder.
/// Empty = none.
QString droppedMap(const QList<QUrl>& urls);
/// For file dialogs: maps and recordings.
QString mapFileFilter();

/// Asks for the position of a picture without a map.yaml.
class PictureDialog : public QDialog {
  Q_OBJECT
 public:
  /// `named_by`: the map.yaml files that name it as their image, none or several. `accept_text`: the text of
  /// the button, "Open".
  PictureDialog(const QString& path, const QStringList& named_by, const QString& accept_text,
                QWidget* parent = nullptr);
  /// nullopt while a field is invalid.
  std::optional<PicturePlacement> placement() const;
  QString errorText() const;
  QString introText() const;

 private:
  void check();
  QLineEdit *resolution_, *x_, *y_, *yaw_;
  QLabel *intro_, *error_;
  QPushButton* open_;
};

/// Why the input is invalid; empty if it is valid.
QString noPlacementReason(const QString& resolution, const QString& x, const QString& y,
                          const QString& yaw_deg);

class PicturePlacing : public QObject {
  Q_OBJECT
 public:
  using Then = std::function<void(const QString& address)>;

  /// `yamls_naming`: returns the map.yaml files that name a picture as their image; accesses the disk, called
  /// on any thread. Null: always asks.
  PicturePlacing(QWidget* window, std::function<QStringList(const QString& picture)> yamls_naming,
                 std::shared_ptr<work::Workers> workers);

  /// Continues with the address of the map. Only the last request counts.
  void place(const QString& path, const QString& accept_text, const Then& then);
  PictureDialog* dialog() const;  // null: not open

 private:
  void ask(const QString& path, const QStringList& named_by, const QString& accept_text, const Then& then);

  QWidget* window_;
  std::function<QStringList(const QString& picture)> yamls_naming_;
  QPointer<PictureDialog> dialog_;
  quint64 asked_ = 0;
  work::Tasks share_;  // last member: waits for the look-up
};

}  // namespace mapwright::ui
