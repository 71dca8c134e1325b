// The maps stored on the robot, and the one that is open here.
#pragma once

#include <optional>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class MapsDock;

class MapsController : public Controller {
  Q_OBJECT
 public:
  explicit MapsController(WindowContext& context, QObject* parent = nullptr);

  MapsDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;
  /// Shows a map of the catalogue without loading it on the robot.
  void open(const map::MapKey& key);
  /// The next change of the maps was made here.
  void expectOwnChange() { own_change_ = true; }

 Q_SIGNALS:
  void compareWanted(const mapwright::map::MapKey& key);
  void alignWanted(const mapwright::map::MapKey& key);
  /// The open map has been read; export it.
  void exportWanted();
  void retryWanted();
  /// Show the live map of a robot that sends it by region.
  void regionsWanted();

 private:
  bool catalogueComesFirst() const;
  void show(const map::MapKey& key);
  /// Fetched from the robot's map, and only on screen.
  bool isFetched(const map::MapKey& key) const;
  void forget(const map::MapKey& key);
  void openToExport(const map::MapKey& key);
  void onMapChanged();
  void onOtherFile();
  /// What the map on screen is called if the robot listed it and does not any more; otherwise empty.
  QString deletedMap(const session::Session& session);
  void fitNew();
  void refreshNotice();

  WindowContext& context_;
  MapsDock* dock_;
  /// The next whole map was requested by the user: show all of it.
  bool fit_next_ = false;
  bool own_change_ = false;
  bool deletion_shown_ = false;
  std::optional<map::CatalogueEntry> listed_;  // of what is on screen, when the robot last listed it
  std::optional<map::MapKey> fitted_;
  std::optional<map::MapKey> export_when_read_;
  /// What was on screen when its file changed, which is being read.
  std::optional<map::WholeMap> changed_;
};

}  // namespace mapwright::ui
