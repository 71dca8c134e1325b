// A report as one HTML file, written piece by piece: it needs no network, no script and no other file. All
// texts are plain: nothing in them becomes markup.
#pragma once

#include <string>
#include <vector>

#include <QByteArray>
#include <QIODevice>
#include <QSize>
#include <QString>
#include <QStringList>

namespace mapwright::page {

/// Plain text as HTML, also for attributes in double quotes.
QString escaped(const QString& text);
/// A text of others for use in a sentence: one harmless line that does not turn the direction of what
/// follows.
QString named(const QString& untrusted);
QString named(const std::string& untrusted);

/// The colour of a text. It only repeats what the text says.
enum class Tone { Plain, Good, Warning, Bad, Muted };

struct Cell {
  Cell(QString words, Tone how = Tone::Plain) : text(std::move(words)), tone(how) {}
  QString text;
  Tone tone = Tone::Plain;
  bool number = false;  // aligned to the right
  QString link = {};    // to the section of this anchor; empty: none
};
/// A cell of a table that is a figure.
Cell figure(QString text, Tone tone = Tone::Plain);

/// Swipe: the few lines that move the edge of swipe(). No other script runs in a page.
enum class Scripts { None, Swipe };

class Page {
 public:
  /// Writes the head and the title. `out` is open and outlives this.
  Page(QIODevice& out, const QString& title, Scripts scripts = Scripts::None);
  /// Ends the page.
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Begins a section, ending the one before. `anchor`: our own letters and digits; empty: none.
  void section(const QString& title, const QString& anchor = {});
  /// A title inside a section.
  void title(const QString& title);
  void paragraph(const QString& text, Tone tone = Tone::Plain);
  void list(const QStringList& items);
  /// A table of two columns: what, and its value. Several values stand below each other.
  struct Fact {
    QString what;
    std::vector<Cell> values;
  };
  void facts(const std::vector<Fact>& facts);
  /// A table that is written row by row.
  void beginTable(const QStringList& head);
  void row(const std::vector<Cell>& cells);
  void endTable();
  /// A PNG; an empty size is the picture's own. `alt`: what it shows, for those who do not see it; the
  /// caption may be empty.
  void picture(const QByteArray& png, const QSize& size_px, const QString& alt, const QString& caption = {});
  /// Two PNGs over each other; a slider moves the edge between them (Scripts::Swipe).
  void swipe(const QByteArray& left, const QByteArray& right, const QString& left_name,
             const QString& right_name);
  /// An SVG element, which is trusted. Its classes are those of the style sheet (page.cpp).
  void drawing(const QByteArray& svg, const QString& caption = {});
  /// What follows stands side by side where there is room, each from here or from nextColumn() on.
  void beginColumns();
  void nextColumn();
  void endColumns();

  /// Writes the rest. False: `out` has not taken everything.
  bool end();

 private:
  void put(const QByteArray& bytes);
  void put(const QString& html) { put(html.toUtf8()); }
  void putImage(const QByteArray& png, const QSize& size_px, const QString& alt, const QString& more = {});
  void endSection();

  QIODevice& out_;
  const Scripts scripts_;
  bool good_ = true, in_section_ = false, ended_ = false;
};

}  // namespace mapwright::page
