package simbad.figures.blindcheck;

import simbad.figures.markup.Markup;

/** What the page's style sheet adds to that of a diagnosis. */
final class CheckStyle {
  static final String SHEET =
      Markup.PLOT_STYLE
          + """
      h3.part { margin: 1.2rem 0 .3rem; }
      .scores { width: 100%; } .scores th[scope=row] { font-weight: 400; min-width: 13rem; }
      .scores td { white-space: nowrap; } .scores .track { position: relative; height: 6px; min-width: 9rem;
        background: var(--rule); border-radius: 3px; margin: 3px 0; }
      .scores .track i { position: absolute; top: 0; height: 6px; }
      .scores .span { background: var(--after); opacity: .45; border-radius: 3px; }
      .scores .dot { width: 6px; margin-left: -3px; border-radius: 3px; background: var(--after); }
      .scores .track .reach { width: 2px; margin-left: -1px; top: -3px; height: 12px; background: var(--ink); }
      .met { color: var(--after); } .missed { color: var(--alarm); font-weight: 600; }
      figure img { display: block; width: 100%; max-width: 400px; height: auto; margin: 0 auto; }
      .columns { columns: 20rem; } .columns div { break-inside: avoid; }
      .confusion caption { text-align: left; color: var(--soft); padding-bottom: .3rem; }
      .confusion thead th { vertical-align: bottom; font-weight: 400; }
      .confusion tbody th { font-weight: 400; white-space: nowrap; }
      .confusion { margin: .6rem 0 1rem; } .upright thead th span { writing-mode: vertical-rl; transform: rotate(180deg); }
      .confusion td { padding: .2rem .5rem; min-width: 2.2rem; }
      .confusion .s1 { background: color-mix(in srgb, var(--after) 10%, transparent); }
      .confusion .s2 { background: color-mix(in srgb, var(--after) 20%, transparent); }
      .confusion .s3 { background: color-mix(in srgb, var(--after) 30%, transparent); }
      .confusion .s4 { background: color-mix(in srgb, var(--after) 40%, transparent); }
      .confusion .s5 { background: color-mix(in srgb, var(--after) 50%, transparent); }
      """;

  private CheckStyle() {}
}
