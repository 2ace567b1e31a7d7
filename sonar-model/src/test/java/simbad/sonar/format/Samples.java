package simbad.sonar.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/** Good files that tests spoil. */
public final class Samples {
  public static final String TABLE =
      """
      # object: post
      # provenance: captured
      bearing_deg,threshold_m
      0,1
      90,2.5
      180,0
      270,4
      """;

  public static final String READINGS =
      """
      run,sensor,t_s,x_m,z_m,heading_deg,range_m
      a,left,0.00,1.5,-0.25,90,0.42
      a,left,0.05,1.5,-0.20,95,
      b,"r,1",0,0,0,-180,0
      """;

  /** A model for the scene of {@link #scene()}. */
  public static final String MODEL =
      """
      {
        "format": "sonar-model/1",
        "sensors": ["left", "right"],
        "setup": [
          {"form": "tails", "parameters": {"share": 0.25, "deviation_m": 0.04}},
          {"form": "threshold:post", "parameters": {
            "constant": 0.01, "cos_1": 0.02, "sin_1": 0, "cos_2": 0, "sin_2": -0.03, "cos_3": 0,
            "sin_3":0,"cos_4":0,"sin_4":0,"cos_5":0,"sin_5":0,"cos_6":0,"sin_6":0,"cos_7":0,"sin_7":0}}
        ],
        "changes": [
          {"effect": "gain", "form": "factor", "parameters": {"factor": 0.8}},
          {"effect": "early-timeout", "form": "soft",
            "parameters": {"start_m": "infinity", "soft_m": 0.05}},
          {"effect": "beam-misalignment", "form": "only:right", "parameters": {"turn_deg": 5}}
        ]
      }
      """;

  private Samples() {}

  public static String scene() throws IOException {
    try (InputStream in = Samples.class.getResourceAsStream("/format/scene.json")) {
      return new String(Objects.requireNonNull(in).readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** The object of the scene's field "sensor". */
  public static String sensor() throws IOException {
    String scene = scene();
    int from = scene.indexOf('{', 1);
    return scene.substring(from, scene.indexOf('}') + 1);
  }
}
