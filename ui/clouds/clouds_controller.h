// Clouds of the robot's map: fetch by region, show, cut, save.
#pragma once

#include "clouds/cloud_store.h"
#include "jobs/fetch_cloud.h"
#include "robot/call.h"
#include "robot/map_dispatch.h"
#include "ui/kit/controller.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class CloudsDock;
class RegionTool;
class SectionDock;
class SectionTool;

class CloudsController : public Controller {
  Q_OBJECT
 public:
  /// The clouds of the map that the scene draws; they outlive this.
  CloudsController(WindowContext& context, clouds::CloudStore& clouds, QObject* parent = nullptr);

  CloudsDock* dock() const { return dock_; }
  clouds::CloudStore& store() const { return clouds_; }
  SectionDock* sectionDock() const { return section_dock_; }
  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  void reset() override;
  std::vector<Fetched> fetched() override;

  /// nullopt: the whole map. Only one request at a time.
  void fetch(const std::optional<map::CloudRegion>& region);
  /// Writes what is shown; the extension selects the format. `then`: called when it is written.
  void saveTo(const QString& path, std::function<void()> then = {});

 private:
  void fetchBox(const geometry::WorldRect& box);
  void onAnswer(robot::CloudKind kind, const std::optional<map::CloudRegion>& region,
                const robot::Outcome<jobs::FetchedCloud>& outcome);
  const scene::LayerStyle& style() const;
  robot::MapDispatch* dispatch() const;
  void refreshOffer();
  void refreshClouds();
  void cut();
  void showSection();
  void openSection();
  void askAndSave(std::function<void()> then = {});

  WindowContext& context_;
  clouds::CloudStore& clouds_;
  CloudsDock* dock_;
  SectionDock* section_dock_;
  SectionTool* section_tool_;
  RegionTool* region_tool_;
  robot::Call call_;
  bool unsaved_ = false;     // data has arrived since everything was last written
  std::uint64_t asked_ = 0;  // counts the requests: answers to older ones are ignored
  std::optional<clouds::Cut> cut_;
  std::shared_ptr<const clouds::Section> section_;
};

}  // namespace mapwright::ui
