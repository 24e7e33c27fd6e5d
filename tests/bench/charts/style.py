"""What all charts share: one look, one colour a program, names, labels that do not overlap."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# Okabe and Ito's palette, told apart with any colour vision; a family of methods is one colour.
VERMILION, ORANGE = "#D55E00", "#E69F00"
BLUE, GREEN, SKY, GREY = "#0072B2", "#009E73", "#56B4E9", "#666666"

# name in the tables: (name in charts, colour, marker, line)
LOOKS = {
    "hazumi": ("Hazumi", VERMILION, "o", "-"),
    "hazumi_exact": ("Hazumi exact", VERMILION, "o", "-"),
    "hazumi_exact_new_file": ("Exact, as a new file", VERMILION, "o", "--"),
    "hazumi_articulated": ("Hazumi articulated", VERMILION, "o", "-"),
    "hazumi_paper": ("The paper's step", ORANGE, "D", "-"),
    "hazumi_paper_way": ("The paper's way", ORANGE, "D", "-"),
    "mujoco": ("MuJoCo", BLUE, "^", "-"),
    "mujoco_rk4": ("MuJoCo RK4", BLUE, "^", "-"),
    "mujoco_rk4_ball": ("MuJoCo RK4, ball joint", BLUE, "^", "-"),
    "mujoco_euler": ("MuJoCo Euler", BLUE, "v", "--"),
    "mujoco_implicit": ("MuJoCo implicit", BLUE, "P", ":"),
    "mujoco_euler_ball": ("MuJoCo Euler, ball joint", BLUE, "v", "--"),
    "simbody": ("Simbody", GREEN, "s", "-"),
    "simbody_merson": ("Simbody Merson", GREEN, "s", "-"),
    "simbody_merson_ball": ("Simbody Merson, ball joint", GREEN, "s", "-"),
    "simbody_fehlberg": ("Simbody Fehlberg", GREEN, "d", "--"),
    "simbody_implicit": ("Simbody CPodes", GREEN, "P", ":"),
    "simbody_semi_explicit_euler": ("Simbody Euler", GREEN, "v", "-."),
    "bullet": ("Bullet", SKY, "<", "-"),
    "bullet_ball": ("Bullet, ball joint", SKY, "<", "-"),
    "dart": ("DART", GREY, ">", "-"),
    "dart_ball": ("DART, ball joint", GREY, ">", "-"),
}


def look(subject):
    """(name, colour, marker, line) of a subject; one that is not in the list is drawn in black."""
    return LOOKS.get(subject, (subject.replace("_", " "), "black", "*", "-"))


def in_sentence(subject):
    """The name of a subject elsewhere than at the start of a sentence."""
    name = look(subject)[0]
    return name.replace("The ", "the ", 1) if name.startswith("The ") else name


def family(subject):
    """The program a subject belongs to."""
    return subject.split("_")[0]


def start():
    """Sets the look of every chart. Text becomes outlines, so that no font is needed to show it."""
    plt.rcParams.update({
        "svg.fonttype": "path", "svg.hashsalt": "hazumi", "figure.dpi": 200, "savefig.dpi": 200,
        "font.family": "DejaVu Sans", "font.size": 8.5, "axes.titlesize": 8.5,
        "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.6,
        "axes.grid": True, "grid.color": "#E4E4E4", "grid.linewidth": 0.5,
        "axes.axisbelow": True, "xtick.major.width": 0.6, "ytick.major.width": 0.6,
        "xtick.minor.size": 0, "ytick.minor.size": 0, "lines.linewidth": 1.5,
        "lines.markersize": 4.5, "legend.frameon": False})


def headline(figure, finding, detail):
    """The finding in bold, and below it what is shown, at the top left of the figure."""
    height = figure.get_size_inches()[1]
    title = figure.text(0.012, 1 - 0.24 / height, finding, ha="left", va="baseline", fontsize=11.5,
                        fontweight="bold")
    room = 0.976 * figure.bbox.width / title.get_window_extent().width
    title.set_fontsize(min(11.5, 11.5 * room))
    figure.text(0.012, 1 - 0.44 / height, detail, ha="left", va="baseline", fontsize=8.5,
                color="#444444")


def second_line(figure, text):
    """Below the headline's detail."""
    height = figure.get_size_inches()[1]
    figure.text(0.012, 1 - 0.61 / height, text, ha="left", va="baseline", fontsize=7.5,
                color="#444444")


def footnote(figure, comment):
    """The machine, in small print."""
    figure.text(0.012, 0.012, comment, ha="left", va="bottom", fontsize=5.2, color="#777777")


def spread(positions, gap, low, high):
    """The positions moved apart to at least `gap`, as little as possible, within [low, high]."""
    order = sorted(range(len(positions)), key=lambda i: positions[i])
    groups = [[positions[i], [i]] for i in order]  # [centre, members in order]
    merged = True
    while merged:
        merged = False
        for a, b in zip(groups, groups[1:]):
            half = gap * (len(a[1]) + len(b[1])) / 2
            if b[0] - a[0] >= half - 1e-12:
                continue
            sizes = len(a[1]), len(b[1])
            a[0] = (a[0] * sizes[0] + b[0] * sizes[1]) / sum(sizes)
            a[1] += b[1]
            groups.remove(b)
            merged = True
            break
        for group in groups:
            half = gap * (len(group[1]) - 1) / 2
            group[0] = min(max(group[0], low + half), max(high - half, low + half))
    moved = list(positions)
    for centre, members in groups:
        for k, i in enumerate(members):
            moved[i] = centre + gap * (k - (len(members) - 1) / 2)
    return moved


def label_right(axes, labels, gap=0.052, size=8):
    """Writes (text, colour, x, y of its line's end) in the right margin, with leaders."""
    to_axes = axes.transData + axes.transAxes.inverted()
    ends = [to_axes.transform((x, y)) for _, _, x, y in labels]
    heights = spread([end[1] for end in ends], gap, 0.0, 1.0)
    for (text, colour, _, _), end, height in zip(labels, ends, heights):
        axes.plot([end[0], 1.012, 1.03], [end[1], height, height], transform=axes.transAxes,
                  color=colour, linewidth=0.5, alpha=0.7, clip_on=False, zorder=1.5)
        axes.text(1.037, height, text, transform=axes.transAxes, color=colour, va="center",
                  fontsize=size, fontweight="bold" if text.startswith("Hazumi") else "normal")


def two_digits(value):
    """The value rounded to two digits, without an exponent."""
    return f"{float(f'{value:.2g}'):g}"


def duration(microseconds, _=None):
    """With its unit, two digits."""
    for unit, size in (("µs", 1.0), ("ms", 1e3), ("s", 1e6)):
        value = float(f"{microseconds / size:.2g}")
        if value < 1000:
            break
    return f"{value:g} {unit}"


def save(figure, folder, name):
    """Writes NAME.svg and NAME.png."""
    figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
    figure.savefig(folder / f"{name}.png")
    plt.close(figure)
    print(f"chart: {folder / name}.png")
