package simbad.figures.diagnosis;

/**
 * The page's style sheet, light and dark. Before and after are vermillion and blue of Okabe and Ito
 * (Color Universal Design, 2008), which also differ in lightness; shades are ColorBrewer's YlGnBu
 * (Brewer, 2003), which darkens all the way on light paper and brightens on dark. Words are in a
 * darker vermillion: on light paper that of the bars has too little contrast to be read (WCAG
 * 1.4.3).
 */
public final class Style {
  /** Colours are custom properties, so that other pages take the reader's theme with it. */
  public static final String SHEET =
      """
      :root { color-scheme: light dark; --paper: #fff; --ink: #1a1a1a; --soft: #555; --rule: #d0d0d0;
        --panel: #f6f6f4; --before: #d55e00; --alarm: #b34f00; --after: #0072b2; --floor: #757575; --unknown: #8a5a83;
        --h0: #ffffd9; --h1: #edf8b1; --h2: #c7e9b4; --h3: #7fcdbb; --h4: #41b6c4; --h5: #1d91c0;
        --h6: #225ea8; --h7: #253494; --h8: #081d58; --edge: #000; }
      @media (prefers-color-scheme: dark) {
        :root { --paper: #161618; --ink: #ececec; --soft: #b0b0b0; --rule: #47474c; --panel: #212124;
          --before: #f08a3c; --alarm: #f08a3c; --after: #56b4e9; --floor: #9a9a9a; --unknown: #cc9ac4;
          --h0: #10235c; --h1: #253494; --h2: #225ea8; --h3: #1d91c0; --h4: #41b6c4; --h5: #7fcdbb;
          --h6: #c7e9b4; --h7: #edf8b1; --h8: #ffffd9; --edge: #fff; }
      }
      * { box-sizing: border-box; }
      body { margin: 0; background: var(--paper); color: var(--ink);
        font: 16px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
      main { max-width: 76rem; margin: 0 auto; padding: 1rem 1.25rem 3rem; }
      h1 { font-size: 1rem; font-weight: 600; color: var(--soft); margin: .25rem 0 .5rem; }
      h2 { font-size: 1.2rem; margin: 2.2rem 0 .5rem; }
      h3 { font-size: 1rem; margin: 0 0 .5rem; }
      p { margin: .4rem 0; max-width: 52rem; }
      .verdict { font-size: 1.3rem; line-height: 1.4; max-width: 60rem; margin: 0 0 .5rem; }
      .note { border-left: 4px solid var(--before); padding-left: .7rem; }
      .soft { color: var(--soft); font-size: .9rem; }
      .panels { display: grid; grid-template-columns: repeat(auto-fit, minmax(21rem, 1fr)); gap: 1rem;
        margin: .9rem 0; }
      .panel { background: var(--panel); border-radius: 8px; padding: .8rem 1rem; min-width: 0; }
      .bars { display: grid; grid-template-columns: minmax(6.5rem, max-content) 1fr max-content;
        gap: .4rem .7rem; align-items: center; font-variant-numeric: tabular-nums; }
      .bars .track { position: relative; height: 1.1rem; background: var(--rule); border-radius: 3px; }
      .bars .fill { position: absolute; inset: 0 auto 0 0; border-radius: 3px; }
      .bars .whisker { position: absolute; top: 50%; height: 3px; margin-top: -1.5px; background: var(--ink); }
      .bars .whisker::before, .bars .whisker::after { content: ""; position: absolute; top: -4px; width: 3px;
        height: 11px; background: var(--ink); }
      .bars .whisker::before { left: 0; } .bars .whisker::after { right: 0; }
      .bars .value { text-align: right; }
      .fill.after { background: var(--after); } .fill.before { background: var(--before); }
      .fill.floor { background: var(--floor); } .fill.unknown { background: var(--unknown); }
      .budget { display: flex; height: 1.4rem; border-radius: 3px; overflow: hidden; margin: .2rem 0; }
      .budget .fill { flex-basis: 0; min-width: 0; }
      .effect0 { background: #0072b2; } .effect1 { background: #e69f00; } .effect2 { background: #009e73; }
      .figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1rem; }
      figure { margin: 0; min-width: 0; background: var(--panel); border-radius: 8px; padding: .7rem; }
      figcaption { font-size: .9rem; color: var(--soft); }
      figure h3 { margin: 0 0 .3rem; }
      svg { display: block; width: 100%; max-width: 440px; height: auto; margin: 0 auto;
        font: 14px system-ui, "DejaVu Sans", sans-serif; }
      svg text { fill: var(--ink); }
      svg .grid { stroke: var(--rule); fill: none; } svg .axis { stroke: var(--soft); fill: none; }
      svg .before { fill: var(--before); } svg .after { fill: var(--after); }
      svg .floor { stroke: var(--ink); stroke-width: 1.5; stroke-dasharray: 5 4; fill: none; }
      svg .ring { stroke: var(--soft); stroke-opacity: .55; fill: none; }
      svg .rim { stroke: var(--soft); fill: none; } svg .dot { fill: var(--ink); }
      svg .edge { stroke: var(--edge); stroke-width: 1.3; fill: none; stroke-dasharray: 4 3; }
      svg .body { fill: var(--soft); stroke: var(--ink); } svg .ping { fill: var(--after); }
      svg .aim { stroke: var(--after); stroke-width: 1.4; }
      svg .h0 { fill: var(--h0); } svg .h1 { fill: var(--h1); } svg .h2 { fill: var(--h2); }
      svg .h3 { fill: var(--h3); } svg .h4 { fill: var(--h4); } svg .h5 { fill: var(--h5); }
      svg .h6 { fill: var(--h6); } svg .h7 { fill: var(--h7); } svg .h8 { fill: var(--h8); }
      .key { display: inline-block; width: .8rem; height: .8rem; border-radius: 2px; vertical-align: -1px; }
      .key.unknown { background: var(--unknown); } .key.floor { background: var(--floor); }
      .key.before { background: var(--before); } .key.after { background: var(--after); }
      .scroll { overflow-x: auto; }
      table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; }
      th, td { padding: .25rem .7rem .25rem 0; text-align: left; border-bottom: 1px solid var(--rule);
        vertical-align: top; }
      td.n, th.n { text-align: right; }
      code { font-size: .85rem; overflow-wrap: anywhere; }
      summary { cursor: pointer; }
      """;

  private Style() {}

  /**
   * Returns a page up to its first heading.
   *
   * @param title as markup
   */
  static String head(String title) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
        + title
        + "</title>\n<style>\n"
        + SHEET
        + "</style>\n</head>\n<body>\n<main>\n";
  }
}
