package simbad.blindworld.wavechange;

import java.util.List;
import java.util.stream.Stream;
import simbad.blindworld.effect.Vocabulary;

/** The names of what can change in a world of waves, and how each is drawn. */
public final class WaveVocabulary {

  private static final List<WaveForm> FORMS =
      Stream.of(ReadingChanges.all(), SceneChanges.all(), SonarChanges.all(), OutsideChanges.all())
          .flatMap(List::stream)
          .toList();

  private WaveVocabulary() {}

  /** Names of the vocabulary that physics can bring about here, sorted. */
  public static List<String> names() {
    return all().filter(Vocabulary::contains).toList();
  }

  /** Names of what the vocabulary does not cover, sorted. */
  public static List<String> outside() {
    return all().filter(name -> !Vocabulary.contains(name)).toList();
  }

  private static Stream<String> all() {
    return FORMS.stream().map(WaveForm::name).distinct().sorted();
  }

  /** True when the change can only happen to a robot. */
  public static boolean needsRobot(String name) {
    return FORMS.stream().anyMatch(f -> f.name().equals(name) && f.driven());
  }

  /** True when the change can happen here. */
  public static boolean applies(String name, Site site) {
    return FORMS.stream().anyMatch(f -> f.name().equals(name) && f.applies().test(site));
  }

  /** The change, drawn by chance; only where it applies. */
  public static WaveEffect draw(String name, Site site) {
    return FORMS.stream()
        .filter(f -> f.name().equals(name) && f.applies().test(site))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " does not apply"))
        .draw()
        .apply(site);
  }
}
