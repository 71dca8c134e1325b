// Fetches the whole of a large map, or a rectangle, once. One at a time; includes the questions.
#pragma once

#include <functional>
#include <memory>

#include <QElapsedTimer>
#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include "disk/existing.h"
#include "regions/region_fetch.h"
#include "ui/kit/background_run.h"
#include "ui/kit/controller.h"
#include "ui/shell/notices.h"
#include "ui/shell/window_context.h"

namespace mapwright::jobs {
class ExportJob;
struct WholeMapExport;
}  // namespace mapwright::jobs

namespace mapwright::ui {

class MapFetch : public QObject {
  Q_OBJECT
 public:
  explicit MapFetch(WindowContext& context, QObject* parent = nullptr);
  ~MapFetch() override;

  /// The dispatcher, and what is known of its map; both null: none. Cancels the request in progress.
  void setDispatch(robot::MapDispatch* dispatch, const regions::RegionMap* map);

  bool busy() const { return fetch_ || whole_in_progress_; }
  /// The notice about it; an empty sentence while nothing is fetched.
  Notice notice();
  QMessageBox* question() const { return question_; }  // null = none is open

  /// Asks first, showing the known size.
  void fetchWhole();
  /// Asks what to do with it.
  void onRectangle(const geometry::WorldRect& rect);
  /// Fetches the rectangle and writes `path`.pgm and .yaml, or shows it as a map.
  void saveRectangle(const geometry::WorldRect& rect, const QString& path);
  void keepRectangle(const geometry::WorldRect& rect);
  void stop();
  void closeQuestion();

  /// What was fetched, is shown as a map and not saved; empty = nothing.
  std::vector<Fetched> fetched();
  /// What is shown has been saved.
  void markSaved() { kept_.reset(); }

 Q_SIGNALS:
  void changed();       // busy(), notice()
  void regionWanted();  // a rectangle of it, as the whole is not available

 private:
  enum class Then { Show, Save };
  void startWhole();
  void refuseWhole(const QString& why);
  /// In the question that is being asked: what goes, if it is answered with yes.
  void sayReplaced();
  void endWhole(const robot::Outcome<map::GridPart>& outcome);
  void startRectangle(const geometry::WorldRect& rect, Then then, const QString& path);
  void endRectangle();
  void show(std::function<map::OccupancyCells()> cells, const map::GridReference& grid, const QString& name);
  void write(const jobs::WholeMapExport& map, const QString& path, disk::Existing existing,
             std::function<void()> then);
  QString askWhere();  // empty = nowhere
  void saveKept(const std::function<void()>& then);
  void toast(Mark mark, const QString& text);

  WindowContext& context_;
  QPointer<robot::MapDispatch> dispatch_;
  QPointer<const regions::RegionMap> map_;
  QPointer<QMessageBox> question_;
  std::unique_ptr<regions::RegionFetch> fetch_;
  Then then_ = Then::Show;
  QString path_;
  disk::Existing existing_ = disk::Existing::Refuse;  // there
  robot::Call whole_;
  bool whole_in_progress_ = false;
  qint64 whole_bytes_ = 0;  // received so far
  QElapsedTimer whole_began_;
  QTimer every_second_;
  std::uint64_t job_ = 0;            // results of older ones are ignored
  std::optional<map::MapKey> kept_;  // on screen, and not written
  BackgroundRun showing_, export_;
};

}  // namespace mapwright::ui
