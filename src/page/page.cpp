#include "page/page.h"

#include <utility>

#include <QCoreApplication>
#include <QCryptographicHash>

#include "words/qt_plain.h"

namespace mapwright::page {
namespace {

// Colours are those of the reader's choice, light or dark; on paper always light. Drawings use line, curve,
// area, mark and fine.
constexpr const char* kStyle = R"(
:root{color-scheme:light dark;--ink:#1d2125;--muted:#5a626b;--line:#d3d8de;--soft:#f3f5f7;--ground:#fff;
--good:#1a7336;--warning:#8a5a00;--bad:#b9232b;--accent:#0a5fc0}
@media (prefers-color-scheme:dark){:root{--ink:#e3e6e9;--muted:#9ba4ae;--line:#3c434b;--soft:#23282d;--ground:#181b1f;
--good:#5cc27c;--warning:#dfa63c;--bad:#f0767c;--accent:#6fb0f5}}
@media print{:root{color-scheme:light;--ink:#000;--muted:#444;--line:#aaa;--soft:#f3f3f3;--ground:#fff;
--good:#1a7336;--warning:#8a5a00;--bad:#b9232b;--accent:#0a5fc0}}
*{box-sizing:border-box}
body{margin:0 auto;padding:1.5rem 1.25rem 3rem;max-width:72rem;color:var(--ink);background:var(--ground);
font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans",sans-serif;overflow-wrap:anywhere}
h1{font-size:1.6rem;line-height:1.25;margin:0 0 .5rem}
h2{font-size:1.15rem;margin:2rem 0 .5rem;padding-bottom:.2rem;border-bottom:1px solid var(--line)}
h3{font-size:1rem;margin:1.2rem 0 .4rem}
p{margin:.4rem 0}ul{margin:.4rem 0;padding-left:1.3rem}
.wide{overflow-x:auto}
table{border-collapse:collapse;margin:.4rem 0;font-variant-numeric:tabular-nums}
th,td{padding:.25rem .9rem .25rem 0;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
thead th{color:var(--muted);font-weight:600;white-space:nowrap}
table.facts th{color:var(--muted);font-weight:400;min-width:9rem}
td.number{text-align:right;white-space:nowrap}
td div+div{margin-top:.15rem}
figure{margin:.6rem 0}figcaption{color:var(--muted);font-size:.9rem;margin-top:.25rem}
img{display:block;max-width:100%;height:auto;border:1px solid var(--line);background:#fff}
svg{display:block;width:100%;max-width:38rem;height:auto}
svg text{fill:var(--muted);font-size:11px;font-family:inherit}
svg .line{stroke:var(--line);fill:none}svg .curve{stroke:var(--accent);fill:none;stroke-width:1.6;stroke-linejoin:round}
svg .dot{fill:var(--accent)}svg .mark{stroke:var(--bad);fill:none;stroke-width:1.2}svg .area{fill:var(--soft)}
svg text.strong{fill:var(--ink)}
.good{color:var(--good)}.warning{color:var(--warning)}.bad{color:var(--bad);font-weight:600}.muted{color:var(--muted)}
a{color:var(--accent)}
.swipe{width:fit-content;max-width:100%}.swipe div{position:relative}
.swipe .over{position:absolute;inset:0;clip-path:inset(0 0 0 var(--at,50%))}.swipe input{width:100%;margin:.4rem 0}
.swipe p{display:grid;grid-template-columns:var(--at,50%) 1fr;margin:0;color:var(--muted);font-size:.9rem}
.swipe span{min-width:0;overflow:hidden;white-space:nowrap}.swipe span+span{text-align:right}
.columns{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(26rem,100%),1fr));gap:0 2rem}
.columns>div{min-width:0}
@media print{body{max-width:none;padding:0;font-size:10pt}h2,h3{break-after:avoid}
figure,tr,.facts{break-inside:avoid}.wide{overflow:visible}
.columns{grid-template-columns:none;grid-auto-flow:column;grid-auto-columns:minmax(0,1fr);gap:0 1.2rem;font-size:.85em}
table.facts th{min-width:0}th,td{padding-right:.6rem}}
)";

constexpr const char* kSwipe = R"(
for(const s of document.querySelectorAll('.swipe input'))
s.oninput=()=>s.closest('.swipe').style.setProperty('--at',s.value+'%')
)";

constexpr const char* kToneClass[] = {"", "good", "warning", "bad", "muted"};

QString classOf(Tone tone, bool number = false) {
  QStringList classes;
  if (number) classes << QStringLiteral("number");
  if (tone != Tone::Plain) classes << QLatin1String(kToneClass[int(tone)]);
  return classes.isEmpty() ? QString() : QStringLiteral(" class=\"%1\"").arg(classes.join(QLatin1Char(' ')));
}

// The unit in which base64 has no rest.
constexpr qsizetype kPiece = 3 * 4096;

constexpr QChar kIsolate(0x2068), kEndOfIsolate(0x2069);

}  // namespace

QString escaped(const QString& text) {
  QString html;
  for (const QChar letter : text.toHtmlEscaped()) {
    // HTML knows none of these; those that turn the direction are never ours.
    const ushort code = letter.unicode();
    const bool control = (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7f && code < 0xa0);
    if (code < 0x202a || code > 0x202e) html += control ? QChar(QLatin1Char(' ')) : letter;
  }
  return html;
}

QString named(const QString& untrusted) { return kIsolate + words::plainName(untrusted) + kEndOfIsolate; }

QString named(const std::string& untrusted) { return named(QString::fromStdString(untrusted)); }

Cell figure(QString text, Tone tone) {
  Cell cell(std::move(text), tone);
  cell.number = true;
  return cell;
}

Page::Page(QIODevice& out, const QString& title, Scripts scripts) : out_(out), scripts_(scripts) {
  QByteArray allowed;
  if (scripts == Scripts::Swipe)
    allowed = "; script-src 'sha256-" +
              QCryptographicHash::hash(QByteArray(kSwipe), QCryptographicHash::Sha256).toBase64() + '\'';
  put(QStringLiteral(
          "<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
          "style-src 'unsafe-inline'")
          .arg(QCoreApplication::translate("Page", "en")));
  put(allowed);
  put(
      QStringLiteral("\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     "<meta name=\"generator\" content=\"mapwright\">\n<title>"));
  put(escaped(title));
  put(QByteArray("</title>\n<style>"));
  put(QByteArray(kStyle));
  put(QByteArray("</style>\n</head>\n<body>\n<h1>"));
  put(escaped(title));
  put(QByteArray("</h1>\n"));
}

Page::~Page() { end(); }

void Page::put(const QByteArray& bytes) {
  if (good_) good_ = out_.write(bytes) == bytes.size();
}

void Page::endSection() {
  if (std::exchange(in_section_, false)) put(QByteArray("</section>\n"));
}

bool Page::end() {
  if (!std::exchange(ended_, true)) {
    endSection();
    if (scripts_ == Scripts::Swipe) put(QByteArray("<script>") + kSwipe + QByteArray("</script>\n"));
    put(QByteArray("</body>\n</html>\n"));
  }
  return good_;
}

void Page::section(const QString& title, const QString& anchor) {
  endSection();
  in_section_ = true;
  put(anchor.isEmpty() ? QStringLiteral("<section>") : QStringLiteral("<section id=\"%1\">").arg(anchor));
  put(QStringLiteral("\n<h2>") + escaped(title) + QStringLiteral("</h2>\n"));
}

void Page::title(const QString& title) {
  put(QStringLiteral("<h3>") + escaped(title) + QStringLiteral("</h3>\n"));
}

void Page::paragraph(const QString& text, Tone tone) {
  put(QStringLiteral("<p") + classOf(tone) + QLatin1Char('>') + escaped(text) + QStringLiteral("</p>\n"));
}

void Page::list(const QStringList& items) {
  put(QByteArray("<ul>\n"));
  for (const QString& item : items) put(QStringLiteral("<li>") + escaped(item) + QStringLiteral("</li>\n"));
  put(QByteArray("</ul>\n"));
}

void Page::facts(const std::vector<Fact>& facts) {
  put(QByteArray("<div class=\"wide\"><table class=\"facts\">\n"));
  for (const Fact& fact : facts) {
    put(QStringLiteral("<tr><th scope=\"row\">") + escaped(fact.what) + QStringLiteral("</th><td>"));
    for (const Cell& value : fact.values)
      put(QStringLiteral("<div") + classOf(value.tone) + QLatin1Char('>') + escaped(value.text) +
          QStringLiteral("</div>"));
    put(QByteArray("</td></tr>\n"));
  }
  put(QByteArray("</table></div>\n"));
}

void Page::beginTable(const QStringList& head) {
  put(QByteArray("<div class=\"wide\"><table>\n<thead><tr>"));
  for (const QString& title : head)
    put(QStringLiteral("<th scope=\"col\">") + escaped(title) + QStringLiteral("</th>"));
  put(QByteArray("</tr></thead>\n<tbody>\n"));
}

void Page::row(const std::vector<Cell>& cells) {
  put(QByteArray("<tr>"));
  for (const Cell& cell : cells) {
    put(QStringLiteral("<td") + classOf(cell.tone, cell.number) + QLatin1Char('>'));
    if (!cell.link.isEmpty()) put(QStringLiteral("<a href=\"#%1\">").arg(cell.link));
    put(escaped(cell.text));
    put(cell.link.isEmpty() ? QByteArray("</td>") : QByteArray("</a></td>"));
  }
  put(QByteArray("</tr>\n"));
}

void Page::endTable() { put(QByteArray("</tbody>\n</table></div>\n")); }

void Page::putImage(const QByteArray& png, const QSize& size_px, const QString& alt, const QString& more) {
  put(QByteArray("<img src=\"data:image/png;base64,"));
  for (qsizetype at = 0; at < png.size(); at += kPiece) put(png.mid(at, kPiece).toBase64());
  put(QByteArray("\""));
  if (!size_px.isEmpty())
    put(QStringLiteral(" width=\"%1\" height=\"%2\"").arg(size_px.width()).arg(size_px.height()));
  put(QStringLiteral(" alt=\"") + escaped(alt) + QLatin1Char('"') + more + QLatin1Char('>'));
}

void Page::picture(const QByteArray& png, const QSize& size_px, const QString& alt, const QString& caption) {
  put(QByteArray("<figure>"));
  putImage(png, size_px, alt);
  if (!caption.isEmpty())
    put(QStringLiteral("<figcaption>") + escaped(caption) + QStringLiteral("</figcaption>"));
  put(QByteArray("</figure>\n"));
}

void Page::swipe(const QByteArray& left, const QByteArray& right, const QString& left_name,
                 const QString& right_name) {
  put(QByteArray("<figure class=\"swipe\"><div>"));
  putImage(left, {}, left_name);
  putImage(right, {}, right_name, QStringLiteral(" class=\"over\""));
  put(QStringLiteral("</div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"") +
      escaped(left_name + QStringLiteral(" – ") + right_name) + QStringLiteral("\">"));
  put(QStringLiteral("<p><span>") + escaped(left_name) + QStringLiteral("</span><span>") +
      escaped(right_name) + QStringLiteral("</span></p></figure>\n"));
}

void Page::drawing(const QByteArray& svg, const QString& caption) {
  put(QByteArray("<figure>"));
  put(svg);
  if (!caption.isEmpty())
    put(QStringLiteral("<figcaption>") + escaped(caption) + QStringLiteral("</figcaption>"));
  put(QByteArray("</figure>\n"));
}

void Page::beginColumns() { put(QByteArray("<div class=\"columns\">\n<div>\n")); }
void Page::nextColumn() { put(QByteArray("</div>\n<div>\n")); }
void Page::endColumns() { put(QByteArray("</div>\n</div>\n")); }

}  // namespace mapwright::page
