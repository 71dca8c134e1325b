// The presets of layers, where they can be chosen: a menu, which the View menu and the dock share, and
// actions that the command palette finds.
#pragma once

#include <functional>
#include <vector>

#include <QDialog>
#include <QMenu>
#include <QPointer>
#include <QSettings>

#include "ui/kit/actions.h"
#include "ui/layers/layer_presets.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::ui {

/// Asks for the name of a preset.
class PresetNameDialog : public QDialog {
  Q_OBJECT
 public:
  /// A name that is taken already.
  enum class Taken { No, Own, BuiltIn };
  /// `may_replace`: the name of another preset of the user's is allowed, which is then replaced.
  PresetNameDialog(const QString& title, const QString& name, bool may_replace,
                   std::function<Taken(const QString&)> taken, QWidget* parent);
  QString name() const;
  QLineEdit* field() const { return field_; }
  QPushButton* yes() const { return yes_; }

 private:
  void check();
  QString yes_text_;
  bool may_replace_;
  std::function<Taken(const QString&)> taken_;
  QLineEdit* field_;
  QLabel* note_;
  QPushButton* yes_;
};

class PresetMenu : public QObject {
  Q_OBJECT
 public:
  static constexpr int kLongestName = 40;

  /// All must outlive this. The user's presets are in `settings`, always as they are here.
  PresetMenu(scene::MapScene& scene, QSettings& settings, Actions& actions, QWidget& window,
             QObject* parent = nullptr);
  ~PresetMenu() override;

  QMenu* menu() const { return menu_; }
  const std::vector<LayerPreset>& own() const { return own_; }

  void choose(const LayerPreset& preset);
  /// The present layers; a preset of the user's with that name is replaced.
  void save(const QString& name);
  void rename(const QString& from, const QString& to);
  void remove(const QString& name);
  /// These open a dialog first; null: the present one.
  PresetNameDialog* askForName();
  PresetNameDialog* askForOtherName(const QString& name);

 Q_SIGNALS:
  void chosen();  // the layers are as a preset says

 private:
  std::vector<LayerPreset>::iterator find(const QString& name);
  QAction* offer(const QString& id, const LayerPreset& preset);
  void changed();
  void mark();
  PresetNameDialog* open(const QString& title, const QString& name, std::function<void(QString)> done);

  scene::MapScene& scene_;
  QSettings& settings_;
  Actions& actions_;
  QWidget& window_;
  const std::vector<LayerPreset> built_in_;
  std::vector<LayerPreset> own_;
  QMenu* menu_;
  QAction* save_;
  std::vector<QAction*> built_in_actions_, own_actions_;  // as the presets
  QPointer<PresetNameDialog> dialog_;
};

}  // namespace mapwright::ui
