"""The network of the amortised rival: BayesFlow's comparison of models, with a second head that tells each effect."""

import logging
import os

logging.disable(logging.INFO)
os.environ["KERAS_BACKEND"] = "jax"
os.environ.setdefault("JAX_PLATFORMS", "cpu")
os.environ.setdefault("TQDM_DISABLE", "1")
os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")

import bayesflow
import keras
import numpy as np
from bayesflow.networks import MLP, DeepSet
from bayesflow.scoring_rules import ScoringRule

import sheets


class Model(ScoringRule):
    """Cross-entropy of which model it is: the first numbers of the target, one of them 1."""

    def __init__(self, models: int):
        super().__init__()
        self.models = models

    def get_head_shapes_from_target_shape(self, target_shape):
        return {"logits": (self.models,)}

    def score(self, estimates, targets, weights=None):
        wanted = targets[..., :self.models]
        return keras.ops.mean(keras.losses.categorical_crossentropy(wanted, estimates["logits"], from_logits=True))


class Present(ScoringRule):
    """Cross-entropy of each effect, there or not: the other numbers of the target."""

    def __init__(self, models: int):
        super().__init__()
        self.models = models

    def get_head_shapes_from_target_shape(self, target_shape):
        return {"logits": (target_shape[-1] - self.models,)}

    def score(self, estimates, targets, weights=None):
        wanted, logits = targets[..., self.models:], estimates["logits"]
        each = keras.ops.softplus(logits) - wanted * logits
        return keras.ops.mean(keras.ops.sum(each, axis=-1))


class Comparison(bayesflow.approximators.ModelComparisonApproximator):
    """Compares models by a set of rows and by numbers of the whole; tells also which effects are present."""

    def __init__(self, models: int, settings: dict):
        body = MLP(widths=settings["widths"], dropout=settings["dropout"], norm="layer")
        super().__init__(num_models=models, classifier_network=body, adapter=adapter(), summary_network=summary(settings))
        self.inference_network.scoring_rules = {"cross_entropy": Model(models), "present": Present(models)}

    def chances(self, data: dict, size: int = 128) -> tuple:
        """Probability of each model, and of each effect, for each case."""
        found = [self.part({name: values[i:i + size] for name, values in data.items()})
                 for i in range(0, len(next(iter(data.values()))), size)]
        return tuple(np.vstack(one) for one in zip(*found))

    def part(self, data: dict) -> tuple:
        conditions, _, _ = self._prepare_conditions({name: values.astype(np.float32) for name, values in data.items()})
        told = self.inference_network(xz=None, conditions=conditions)
        models = keras.ops.softmax(told["cross_entropy"]["logits"])
        return np.asarray(models), np.asarray(keras.ops.sigmoid(told["present"]["logits"]))


def summary(settings: dict):
    """A network that turns a set of rows, in any order, into some numbers."""
    return DeepSet(
        summary_dim=settings["summaries"], embed_dim=settings["embed"], depth=2, mlp_widths=(settings["embed"],), dropout=0.0)


def adapter():
    """Which of a case's arrays goes where."""
    return (
        bayesflow.Adapter().rename("target", "inference_variables").rename("numbers", "inference_conditions")
        .rename("rows", "summary_variables"))


def fewer(settings: dict, chance: np.random.Generator, masked: float):
    """Takes other rows of the sets at each step and leaves some numbers out, so that none is learnt by heart."""
    def taken(batch: dict) -> dict:
        kept = chance.permutation(batch["rows"].shape[1])[:settings["rows"]]
        told = chance.random(batch["numbers"].shape) >= masked
        return {**batch, "rows": batch["rows"][:, kept].astype(np.float32), "numbers": batch["numbers"] * told.astype(np.float32)}
    return taken


def learn(data: dict, held: dict, models: int, settings: dict, seed: int, verbose: int = 2):
    """A network that learnt from data; of all its epochs the one that did best on what was held out, and its number."""
    keras.utils.set_random_seed(seed)
    chance = np.random.default_rng(seed)
    network = Comparison(models, settings)
    steps = settings["epochs"] * -(-len(data["target"]) // settings["batch"])
    rate = keras.optimizers.schedules.CosineDecay(0.0, steps, warmup_target=settings["rate"], warmup_steps=steps // 20)
    network.compile(optimizer=keras.optimizers.AdamW(rate, weight_decay=settings["decay"], clipnorm=1.0))
    wiring = adapter()
    training = bayesflow.datasets.OfflineDataset(
        data, settings["batch"], wiring, augmentations=fewer(settings, chance, settings["masked"]))
    judging = bayesflow.datasets.OfflineDataset(
        held, 128, wiring, augmentations=fewer(settings, np.random.default_rng(0), 0), shuffle=False)
    best = keras.callbacks.EarlyStopping(patience=settings["patience"], restore_best_weights=True)
    told = network.fit(dataset=training, validation_data=judging, epochs=settings["epochs"], callbacks=[best], verbose=verbose)
    return network, int(np.argmin(told.history["val_loss"])) + 1


def restored(model: dict, effects: int) -> Comparison:
    """A network that learnt before."""
    network = Comparison(effects + 3, model["settings"])
    network.build({
        "inference_variables": (1, 2 * effects + 3),
        "inference_conditions": (1, model["numbers"]),
        "summary_variables": (1, model["settings"]["rows"], len(sheets.NAMES)),
    })
    network.set_weights(model["weights"])
    return network
