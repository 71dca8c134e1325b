// Asks which part of the open bag to export, as what and where; stays open until it is written. Non-modal.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QDialog>

#include "excerpt/excerpt_job.h"
#include "replay/player.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace mapwright::ui {

/// The open bag.
struct RangeOffer {
  excerpt::ExcerptJob::Source source;
  QString address;                           // of the robot, or the file
  std::string robot_kind;                    // robot::Addresses::kindOf(address)
  QString name;                              // of the bag; untrusted
  double first_s = 0, last_s = 0;            // its time range
  std::optional<replay::Player::Loop> loop;  // proposed, where there is one
  QString folder;
  std::shared_ptr<work::Workers> workers;
  std::function<double()> now = {};  // the time on screen; none = there is none
};

/// "mapwright bags film …" for the same range. For a shell: names are quoted.
QString filmCommand(const RangeOffer& offer, double from_s, double to_s);

class RangeExportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RangeExportDialog(RangeOffer offer, QWidget* parent = nullptr);
  ~RangeExportDialog() override;

  /// The bag is no longer open: cancels work in progress, and nothing more can be started.
  void leaveBag();

  QLineEdit* fromEdit() const { return from_; }
  QLineEdit* toEdit() const { return to_; }
  QComboBox* kindBox() const { return kind_; }
  QLineEdit* pathEdit() const { return path_; }
  QLineEdit* filmEdit() const { return film_; }
  QPushButton* fromHereButton() const { return from_here_; }
  QPushButton* toHereButton() const { return to_here_; }
  QPushButton* exportButton() const { return export_; }
  QPushButton* closeButton() const { return close_; }
  /// Errors, omissions or a question; empty = nothing.
  QString said() const;
  bool running() const { return job_ != nullptr; }

 Q_SIGNALS:
  void exported(const QString& path, const QString& sentence);

 public Q_SLOTS:
  void start();

 protected:
  void reject() override;

 private:
  void layOut();
  void applyKind();
  void applyRange();
  void browse();
  void say(const QString& sentence, bool bad = true);
  void setRunning(bool running);
  void onEnded(const excerpt::Ended& ended);
  /// Why the input is invalid; nullopt: it is valid.
  std::optional<QString> unavailableReason(const QString& path) const;
  std::optional<double> time(const QLineEdit* edit, const QString& shown, double meant_s) const;
  /// nullopt: one of them is not a time.
  std::optional<excerpt::TimeSpan> span() const;

  RangeOffer offer_;
  QLineEdit *from_, *to_, *path_, *film_;
  QComboBox* kind_;
  QPushButton *from_here_, *to_here_, *browse_, *export_, *close_;
  QProgressBar* progress_;
  QLabel* said_;
  QString from_shown_, to_shown_;  // as proposed: these texts mean the exact times
  double from_s_ = 0, to_s_ = 0;   // the proposed ones
  QString asked_;                  // whether this file may be replaced
  bool left_ = false;
  std::unique_ptr<excerpt::ExcerptJob> job_;
};

}  // namespace mapwright::ui
