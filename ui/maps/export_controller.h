// Exports what is on screen to files, or copies it as a picture; asks what, and where.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QDialog>
#include <QImage>
#include <QPointer>

#include "jobs/export_map.h"
#include "ui/kit/background_run.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QRadioButton;

namespace mapwright::ui {

/// What can be exported at present.
struct ExportOffer {
  QString name;                                // of the map, for the proposed file name
  std::optional<jobs::WholeMapExport> whole;   // nullopt: none is complete
  QString why_not_whole;                       // the sentence then
  bool broken = false;                         // parts of `whole` could not be read
  std::vector<render::PlacedTexture> submaps;  // hidden ones too
  std::set<map::SubmapId> hidden;              // of these, the ones hidden by the user
  int without_picture = 0;                     // listed, but without a picture
  bool unsaved = false;                        // `whole` has unsaved changes on screen
  double submap_resolution_m = 0.05;           // of the finest one
  bool prefers_submaps = false;                // submaps are on screen
  std::function<jobs::ViewExport()> view;
  std::vector<std::string> sources;  // the files from which the map on screen was read
  QString folder;
};

class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  ExportDialog(ExportOffer offer, const std::shared_ptr<work::Workers>& workers, QWidget* parent = nullptr);

  QRadioButton* formatButton(jobs::ExportFormat format) const;
  QComboBox* sourceBox() const { return source_; }
  /// Visible if submaps are hidden.
  QCheckBox* hiddenBox() const { return hidden_; }
  QCheckBox* worldFileBox() const { return world_file_; }
  /// How map_server is to read the picture; the thresholds count while the box is checked.
  QComboBox* mapModeBox() const { return map_mode_; }
  QCheckBox* thresholdsBox() const { return thresholds_; }
  QDoubleSpinBox* occupiedBox() const { return occupied_; }
  QDoubleSpinBox* freeBox() const { return free_; }
  QLineEdit* pathEdit() const { return path_; }
  QPushButton* exportButton() const { return export_; }
  /// What will be in the file, and what not.
  QString contentText() const;
  QString errorText() const;
  void start();

 Q_SIGNALS:
  /// `remark`: what robots will not see of it; empty = nothing.
  void exported(const QString& path, const QString& remark);

 protected:
  void reject() override;

 private:
  jobs::ExportFormat format() const;
  grids::MapServerForm form() const;
  bool fromSubmaps() const;
  bool withHidden() const;
  std::vector<render::PlacedTexture> chosenSubmaps() const;
  QString describeContent() const;
  void sync();
  void browse();
  void onFinished(const jobs::ExportResult& result);
  void setRunning(bool running);

  ExportOffer offer_;
  QRadioButton *map_picture_, *map_server_, *view_picture_;
  QComboBox* source_;
  QDoubleSpinBox* resolution_;
  QCheckBox *hidden_, *world_file_;
  QComboBox* map_mode_;
  QCheckBox* thresholds_;
  QDoubleSpinBox *occupied_, *free_;
  QLineEdit* path_;
  QPushButton *browse_, *export_, *cancel_;
  QProgressBar* progress_;
  QLabel *content_, *error_, *source_label_, *resolution_label_, *map_mode_label_;
  bool confirmed_ = false;          // overwriting
  bool source_confirmed_ = false;   // confirmed overwriting a source file
  bool missing_confirmed_ = false;  // confirmed that most of the map is missing
  const std::shared_ptr<work::Workers> workers_;
  BackgroundRun run_;
};

class ExportController : public Controller {
  Q_OBJECT
 public:
  /// `yamls_naming`: see PicturePlacing; null = none.
  ExportController(WindowContext& context, jobs::YamlsNaming yamls_naming, QObject* parent = nullptr);

  void exportMap();
  ExportDialog* dialog() const { return dialog_; }  // null: not open

  /// The map as on screen, without buttons and notices.
  QImage mapPicture() const;
  /// The error is a sentence.
  std::optional<QString> saveMapPicture(const QString& path);

 Q_SIGNALS:
  /// The whole map on screen has been written to a file.
  void wholeExported();

 private:
  void askAndSavePicture();
  void copyPicture();
  /// The local files from which the map on screen was read.
  std::vector<std::string> sourceFiles() const;

  WindowContext& context_;
  jobs::YamlsNaming yamls_naming_;
  QPointer<ExportDialog> dialog_;
};

}  // namespace mapwright::ui
