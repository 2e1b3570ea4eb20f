# SPDX-License-Identifier: GPL-3.0-or-later
"""German.

The words of Blender's own German: Formschlüssel (shape key), Schlüsselbild (keyframe), Einzelbild (frame; on
narrow fields Bild), Treiber (driver), Modifikator, Masche (mesh), Sammlung (collection), Fläche (face), Punkt
(vertex), Startwert (seed), Voreinstellung (saved preset), Begrenzungsrahmen (bounding box), Regler (slider).

Ours, one for one thing: Prompt, Suche (search), Ergebnis (outcome), Teil (part), Box (part box), Leitmodell
(guide), Bewertung (score), Ansicht (view), Generation, Spektrum, Teilung (split), Verfahren (the preset:
standard or the paper's), zerlegen (split, take apart), Stück (piece), sperren (lock).

Prompts are English, for the guide: they, and names of the user's own, are not translated.
"""

MESSAGES = {
    # Panels and menus.
    ("Boxmorph", "Outcomes"): "Ergebnisse",
    ("Boxmorph", "Parts"): "Teile",
    ("Boxmorph", "Search"): "Suche",
    ("Boxmorph", "Guide"): "Leitmodell",
    ("Boxmorph", "Views"): "Ansichten",
    ("*", "Last Prompts"): "Letzte Prompts",
    ("*", "Prompts of the last searches"): "Prompts der letzten Suchen",
    ("*", "Outcome"): "Ergebnis",
    ("*", "More to do with an outcome"): "Was sich mit einem Ergebnis noch tun lässt",
    ("*", "Search Presets"): "Voreinstellungen der Suche",
    ("*", "Apply, save and delete settings of the search. Yours are kept with Blender's other presets"): (
        "Einstellungen der Suche anwenden, speichern und löschen. Eigene liegen bei Blenders anderen "
        "Voreinstellungen"
    ),
    # The search.
    ("Operator", "Deform to Prompt"): "Zum Prompt verformen",
    ("Operator", "Deform {} Objects to Prompt"): "{} Objekte zum Prompt verformen",
    ("Operator", "Add to Queue"): "Einreihen",
    (
        "*",
        "Search a deformation of the active object that looks like the prompt, and add it as a shape "
        "key. While a search runs, the object waits for its end",
    ): (
        "Eine Verformung des aktiven Objekts suchen, die wie der Prompt aussieht, und sie als "
        "Formschlüssel hinzufügen. Läuft schon eine Suche, wartet das Objekt auf deren Ende"
    ),
    ("*", "All Selected"): "Alle ausgewählten",
    ("*", "Deform all selected mesh objects, one after another, not only the active one"): (
        "Alle ausgewählten Maschenobjekte verformen, eines nach dem anderen, nicht nur das aktive"
    ),
    ("Operator", "Cancel"): "Abbrechen",
    ("*", "Stop the search and leave the object as it was; objects that wait are not searched"): (
        "Die Suche anhalten und das Objekt lassen, wie es war; Objekte, die warten, werden nicht durchsucht"
    ),
    ("Operator", "Remove from Queue"): "Aus der Warteschlange nehmen",
    ("*", "Do not search this object"): "Dieses Objekt nicht durchsuchen",
    ("Operator", "Use Prompt"): "Prompt verwenden",
    ("*", "Type this prompt again"): "Diesen Prompt wieder eingeben",
    ("*", "Prompt"): "Prompt",
    (
        "*",
        "What the object should become, in a few words, such as: a bar stool. Names that the guide "
        "knows are suggested",
    ): (
        "Was aus dem Objekt werden soll, in wenigen englischen Worten, etwa: a bar stool. Namen, die "
        "das Leitmodell kennt, werden vorgeschlagen"
    ),
    ("Boxmorph", "Preset"): "Verfahren",
    ("*", "How thoroughly to search. Leave it, unless to compare with what was published"): (
        "Wie gründlich gesucht wird. So lassen, außer zum Vergleich mit dem, was veröffentlicht ist"
    ),
    ("Boxmorph", "Standard"): "Standard",
    ("*", "The result of the full search at a fraction of its cost"): (
        "Was die volle Suche findet, zu einem Bruchteil ihrer Kosten"
    ),
    ("Boxmorph", "Paper"): "Veröffentlichung",
    ("*", "The published protocol, step by step. Much slower"): (
        "Das veröffentlichte Verfahren, Schritt für Schritt. Viel langsamer"
    ),
    ("*", "Seed"): "Startwert",
    (
        "*",
        "Change it where a result does not please: another seed gives another result, the same seed "
        "the same one again",
    ): (
        "Ändern, wo ein Ergebnis nicht gefällt: ein anderer Startwert gibt ein anderes Ergebnis, "
        "derselbe wieder dasselbe"
    ),
    # The settings of the search.
    ("*", "Splits"): "Teilungen",
    (
        "*",
        "How finely to split the object into parts. Raise it where what should change is no part of "
        "its own, lower it where parts are slivers",
    ): (
        "Wie fein das Objekt in Teile zerlegt wird. Erhöhen, wo das, was sich ändern soll, kein "
        "eigener Teil ist; verringern, wo Teile nur Splitter sind"
    ),
    ("*", "Automatic"): "Automatisch",
    ("*", "Try several and keep the best"): "Mehrere versuchen und das beste behalten",
    ("*", "Split the object into parts 1 time"): "Das Objekt 1-mal in Teile zerlegen",
    **{
        ("*", f"Split the object into parts {n} times"): f"Das Objekt {n}-mal in Teile zerlegen"
        for n in range(2, 9)
    },
    ("*", "Symmetry"): "Symmetrie",
    ("*", "Which mirror symmetry to keep. Choose None where the two sides may come to differ"): (
        "Welche Spiegelsymmetrie bleibt. „Keine“ wählen, wo die beiden Seiten verschieden werden dürfen"
    ),
    ("*", "Use the mirror symmetry found in the object, if there is one"): (
        "Die Spiegelsymmetrie, die sich im Objekt findet, wenn es eine hat"
    ),
    ("*", "None"): "Keine",
    ("*", "Let the two sides change separately"): "Die beiden Seiten ändern sich unabhängig",
    ("*", "Keep left and right alike"): "Links und rechts bleiben gleich",
    ("*", "Keep front and back alike"): "Vorn und hinten bleiben gleich",
    ("*", "Keep top and bottom alike"): "Oben und unten bleiben gleich",
    ("*", "X and Y"): "X und Y",
    ("*", "Keep left and right alike, and front and back"): (
        "Links und rechts bleiben gleich, ebenso vorn und hinten"
    ),
    ("*", "Keep"): "Beibehalten",
    (
        "*",
        "Which size of the object the result keeps. Choose one where it must fit: Height for what "
        "stands under something, Footprint for what has its place on the floor",
    ): (
        "Welche Größe des Objekts das Ergebnis behält. Wählen, wo es passen muss: „Höhe“ für das, "
        "was unter etwas steht, „Standfläche“ für das, was seinen Platz am Boden hat"
    ),
    ("*", "Keep the diagonal of the bounding box; where parts are locked, keep their size"): (
        "Die Diagonale des Begrenzungsrahmens beibehalten; wo Teile gesperrt sind, deren Größe"
    ),
    ("*", "Diagonal"): "Diagonal",
    ("*", "Keep the diagonal of the bounding box"): ("Die Diagonale des Begrenzungsrahmens beibehalten"),
    ("*", "Height"): "Höhe",
    ("*", "Keep the height"): "Die Höhe beibehalten",
    ("*", "Footprint"): "Standfläche",
    ("*", "Keep the diagonal of the rectangle on the floor"): (
        "Die Diagonale des Rechtecks am Boden beibehalten"
    ),
    ("*", "Off"): "Aus",
    ("*", "Leave the size as the search finds it"): "Die Größe lassen, wie die Suche sie findet",
    ("*", "Least Scale"): "Mindestmaß",
    (
        "*",
        "No part gets smaller than this share of its size, before the size of the whole is kept. "
        "Raise it where parts come out too thin",
    ): (
        "Kein Teil wird kleiner als dieser Anteil seiner Größe, bevor die Größe des Ganzen "
        "angeglichen wird. Erhöhen, wo Teile zu dünn werden"
    ),
    ("*", "Greatest"): "Höchstmaß",
    (
        "*",
        "No part gets larger than this many times its size, before the size of the whole is kept. "
        "Lower it to stay near the object, raise it for what is far from it",
    ): (
        "Kein Teil wird größer als dieses Vielfache seiner Größe, bevor die Größe des Ganzen "
        "angeglichen wird. Verringern, um nahe am Objekt zu bleiben; erhöhen für das, was fern von "
        "ihm ist"
    ),
    ("*", "Shift Parts"): "Teile verschieben",
    (
        "*",
        "Let parts also slide over those they hang on: legs outwards, wings back. More can be "
        "reached, and the search is less sure to find it",
    ): (
        "Teile auch über die gleiten lassen, an denen sie hängen: Beine nach außen, Flügel nach "
        "hinten. Mehr ist erreichbar, und die Suche findet es weniger sicher"
    ),
    ("Operator", "Add Search Preset"): "Voreinstellung der Suche hinzufügen",
    ("*", "Save the settings of the search as a preset, or delete one"): (
        "Die Einstellungen der Suche als Voreinstellung speichern oder eine löschen"
    ),
    # The running search.
    ("*", "Boxmorph: {}   Esc: Cancel"): "Boxmorph: {}   Esc: Abbrechen",
    ("*", "Waiting"): "Wartet",
    ("*", "Reading the prompt"): "Liest den Prompt",
    ("*", "Finding the parts"): "Sucht die Teile",
    ("*", "Searching with {} part boxes"): "Sucht mit {} Boxen",
    ("*", "Done"): "Fertig",
    ("*", "Generation {}"): "Generation {}",
    ("*", "Generation {} of {}"): "Generation {} von {}",
    ("*", "Score {}"): "Bewertung {}",
    ("*", "{:.0f} s left"): "noch {:.0f} s",
    ("*", "{:.0f} min left"): "noch {:.0f} min",
    # Parts.
    ("Operator", "Find Parts"): "Teile finden",
    ("Operator", "Find Again"): "Neu finden",
    ("*", "Split the active object into parts, to see them and to lock what must not change"): (
        "Das aktive Objekt in Teile zerlegen, um sie zu sehen und zu sperren, was sich nicht ändern darf"
    ),
    ("Operator", "Forget Parts"): "Teile vergessen",
    (
        "*",
        "Forget the parts of the active object and their locks, so that the search splits it as it likes",
    ): (
        "Die Teile des aktiven Objekts und ihre Sperren vergessen, so dass die Suche es zerlegt, wie sie will"
    ),
    ("Operator", "Lock Part"): "Teil sperren",
    ("*", "Keep the part's size on all axes in searches from now on, or unlock it again"): (
        "Die Größe des Teils in künftigen Suchen auf allen Achsen beibehalten, oder ihn wieder entsperren"
    ),
    ("*", "Part"): "Teil",
    ("*", "The part that is chosen in the list"): "Der Teil, der in der Liste gewählt ist",
    ("*", "Lock"): "Sperre",
    ("*", "Keep the part's size along this axis of the object, in searches from now on"): (
        "Die Größe des Teils entlang dieser Achse des Objekts in künftigen Suchen beibehalten"
    ),
    ("*", "Color"): "Farbe",
    ("*", "Color of the part's boxes"): "Farbe der Boxen des Teils",
    ("*", "Boxes"): "Boxen",
    (
        "*",
        "A collection of cubes that stand around the parts, to be used as they are; empty: the parts "
        "are found. For an object that is split otherwise than you would",
    ): (
        "Eine Sammlung von Würfeln, die um die Teile stehen und so verwendet werden; leer: die Teile "
        "werden gesucht. Für ein Objekt, das anders zerlegt wird, als man selbst es täte"
    ),
    ("*", "Show Parts"): "Teile anzeigen",
    ("*", "Draw the parts of the active object as boxes, joined where they hang together"): (
        "Die Teile des aktiven Objekts als Boxen zeichnen, verbunden, wo sie zusammenhängen"
    ),
    ("Operator", "Refine at Part Boundaries"): "An Teilgrenzen verfeinern",
    (
        "*",
        "Cut the faces of the active object that span two parts, close to the boundary on either "
        "side, so that they need not shear. UVs, materials and shape keys stay",
    ): (
        "Die Flächen des aktiven Objekts, die über zwei Teile reichen, beiderseits nahe der Grenze "
        "zerschneiden, so dass sie nicht scheren müssen. UVs, Materialien und Formschlüssel bleiben"
    ),
    ("*", "1 long face spans parts"): "1 lange Fläche über Teilgrenzen",
    ("*", "{} long faces span parts"): "{} lange Flächen über Teilgrenzen",
    ("*", "it is sheared by {:.0f}°"): "sie schert um {:.0f}°",
    ("*", "the worst is sheared by {:.0f}°"): "die schlimmste schert um {:.0f}°",
    # Outcomes.
    ("*", "{:.1f} away"): "{:.1f} weg",
    ("*", "beyond {:.1f}"): "darüber {:.1f}",
    ("*", "Taken apart: {} pieces"): "Zerlegt: {} Stücke",
    ("*", "The active object has no outcome yet. Deform it to a prompt first"): (
        "Das aktive Objekt hat noch kein Ergebnis. Erst zu einem Prompt verformen"
    ),
    ("Operator", "Again with Another Seed"): "Erneut mit anderem Startwert",
    (
        "*",
        "Search again with the outcome's own prompt and settings and the next seed. What is found "
        "takes its place",
    ): (
        "Noch einmal suchen, mit Prompt und Einstellungen des Ergebnisses und dem nächsten "
        "Startwert. Was gefunden wird, tritt an seine Stelle"
    ),
    ("Operator", "Take Apart"): "Zerlegen",
    (
        "*",
        "Make a shape key of each part's width, depth and height, to be tuned by hand. Together they "
        "equal the outcome, which is set to 0 and stays",
    ): (
        "Aus Breite, Tiefe und Höhe jedes Teils einen Formschlüssel machen, von Hand einzustellen. "
        "Zusammen ergeben sie das Ergebnis, das auf 0 gesetzt wird und bleibt"
    ),
    ("Operator", "Put Together"): "Zusammensetzen",
    (
        "*",
        "Delete the shape keys that the outcome was taken apart into, and show the outcome again as "
        "it was. What was tuned by hand on them is lost",
    ): (
        "Die Formschlüssel löschen, in die das Ergebnis zerlegt wurde, und es wieder zeigen, wie es "
        "war. Was an ihnen von Hand eingestellt wurde, geht verloren"
    ),
    ("Operator", "Add Driver Control"): "Treiber-Steuerung hinzufügen",
    (
        "*",
        "Make a custom property of the object that drives the outcome: a slider that can be keyed, "
        "driven by bones, or read by other drivers",
    ): (
        "Eine benutzerdefinierte Eigenschaft des Objekts anlegen, die das Ergebnis treibt: einen "
        "Regler, der Schlüsselbilder nimmt, von Knochen getrieben oder von anderen Treibern gelesen "
        "werden kann"
    ),
    ("Operator", "Apply as New Object"): "Als neues Objekt anwenden",
    (
        "*",
        "Make a new object, in the same place, whose mesh is the outcome as it is shown now, without "
        "shape keys. UVs, materials, groups and modifiers stay",
    ): (
        "Ein neues Objekt an derselben Stelle anlegen, dessen Masche das Ergebnis ist, wie es jetzt "
        "zu sehen ist, ohne Formschlüssel. UVs, Materialien, Gruppen und Modifikatoren bleiben"
    ),
    ("Operator", "Remove Outcome"): "Ergebnis entfernen",
    (
        "*",
        "Delete the outcome: its shape key, those it was taken apart into, its record, its control "
        "and its animation",
    ): (
        "Das Ergebnis löschen: seinen Formschlüssel, die, in die es zerlegt wurde, seine "
        "Aufzeichnung, seine Steuerung und seine Animation"
    ),
    ("Operator", "Mix Outcomes"): "Ergebnisse mischen",
    (
        "*",
        "Mix the outcomes in the ratio of their sliders, evenly where all are at 0, and no farther "
        "than every part stays thick enough",
    ): (
        "Die Ergebnisse im Verhältnis ihrer Regler mischen, gleichmäßig, wo alle auf 0 stehen, und "
        "nur so weit, dass jeder Teil dick genug bleibt"
    ),
    ("*", "Amount"): "Menge",
    (
        "*",
        "What the sliders add up to: 1 mixes whole outcomes, less stays nearer to the object, more "
        "goes beyond them",
    ): (
        "Die Summe der Regler: 1 mischt ganze Ergebnisse, weniger bleibt näher am Objekt, mehr geht "
        "über sie hinaus"
    ),
    ("Operator", "Keyframe Mix"): "Mischung als Schlüsselbild",
    (
        "*",
        "Keyframe the sliders of all outcomes as they are at the current frame. Between two mixes, "
        "all values run along straight lines",
    ): (
        "Für die Regler aller Ergebnisse, wie sie stehen, Schlüsselbilder im aktuellen Einzelbild "
        "einfügen. Zwischen zwei Mischungen laufen alle Werte auf geraden Linien"
    ),
    ("*", "Together, a part gets too thin"): "Zusammen wird ein Teil zu dünn",
    # Animation.
    ("Operator", "Keyframe Spectrum"): "Spektrum als Schlüsselbilder",
    ("*", "Animate the outcome: keyframe its value from one frame to another, as set above the button"): (
        "Das Ergebnis animieren: Schlüsselbilder für seinen Wert von einem Einzelbild zum anderen, "
        "wie über dem Knopf eingestellt"
    ),
    ("*", "Frame"): "Einzelbild",
    ("*", "Value"): "Wert",
    ("*", "to"): "bis",
    ("*", "From Frame"): "Von Bild",
    ("*", "Frame of the first keyframe"): "Einzelbild des ersten Schlüsselbilds",
    ("*", "Frame of the first keyframe: the animation starts here"): (
        "Einzelbild des ersten Schlüsselbilds: hier beginnt die Animation"
    ),
    ("*", "To Frame"): "Bis Bild",
    ("*", "Frame of the last keyframe"): "Einzelbild des letzten Schlüsselbilds",
    ("*", "Frame of the last keyframe: the animation ends here"): (
        "Einzelbild des letzten Schlüsselbilds: hier endet die Animation"
    ),
    ("*", "From Value"): "Von Wert",
    ("*", "Value at the first frame"): "Wert im ersten Einzelbild",
    (
        "*",
        "Slider value at the first frame: 0 is the object as it was, 1 the prompt, below 0 away from it",
    ): (
        "Wert des Reglers im ersten Einzelbild: 0 ist das Objekt, wie es war, 1 der Prompt, unter 0 "
        "von ihm fort"
    ),
    ("*", "To Value"): "Bis Wert",
    ("*", "Value at the last frame"): "Wert im letzten Einzelbild",
    ("*", "Slider value at the second frame: 1 is the prompt, above 1 beyond it"): (
        "Wert des Reglers im zweiten Einzelbild: 1 ist der Prompt, über 1 geht es über ihn hinaus"
    ),
    ("*", "Timing"): "Zeitverlauf",
    (
        "*",
        "How the outcome comes about between the two frames. Choose another where it starts or ends "
        "too suddenly",
    ): (
        "Wie das Ergebnis zwischen den beiden Einzelbildern entsteht. Anders wählen, wo es zu "
        "plötzlich beginnt oder endet"
    ),
    ("*", "Linear"): "Linear",
    ("*", "The value changes evenly"): "Der Wert ändert sich gleichmäßig",
    ("*", "Eased"): "Sanft",
    ("*", "The value starts and ends slowly"): "Der Wert beginnt und endet langsam",
    ("*", "Semantic"): "Semantisch",
    ("*", "The likeness to the prompt grows evenly: keys are placed by the guide's score"): (
        "Die Ähnlichkeit mit dem Prompt wächst gleichmäßig: Schlüsselbilder liegen nach der "
        "Bewertung des Leitmodells"
    ),
    # Judging.
    ("Operator", "Measure Scores"): "Bewertungen messen",
    (
        "*",
        "Measure how much the outcome looks like its prompt from one value to another, and draw the "
        "curve: it shows where on the slider it turns into the prompt",
    ): (
        "Messen, wie sehr das Ergebnis von einem Wert zum anderen seinem Prompt gleicht, und die "
        "Kurve zeichnen: sie zeigt, wo auf dem Regler es zum Prompt wird"
    ),
    ("*", "Value where the curve begins"): "Wert, bei dem die Kurve beginnt",
    ("*", "Value where the curve ends"): "Wert, bei dem die Kurve endet",
    ("Operator", "Evaluate"): "Beurteilen",
    (
        "*",
        "Judge the outcome by numbers: how alike it is to its prompt, how many faces cross others, "
        "how far curvature and shading changed",
    ): (
        "Das Ergebnis nach Zahlen beurteilen: wie ähnlich es seinem Prompt ist, wie viele Flächen "
        "andere durchdringen, wie sehr sich Krümmung und Schattierung geändert haben"
    ),
    ("*", "Likeness to the prompt: {:.3f} before, {:.3f} now"): (
        "Ähnlichkeit mit dem Prompt: vorher {:.3f}, jetzt {:.3f}"
    ),
    ("*", "From the front right: {:.3f} before, {:.3f} now"): (
        "Von vorn rechts: vorher {:.3f}, jetzt {:.3f}"
    ),
    ("*", "Crossing faces: {:.2%} before, {:.2%} now"): (
        "Flächen, die sich durchdringen: vorher {:.2%}, jetzt {:.2%}"
    ),
    ("*", "Crossing faces: not counted, for there are more than {:,} triangles"): (
        "Flächen, die sich durchdringen: nicht gezählt, denn es sind über {:,} Dreiecke"
    ),
    ("*", "Curvature: changed by {:.3f} radians at a vertex on average"): (
        "Krümmung: im Mittel um {:.3f} Radiant je Punkt geändert"
    ),
    ("*", "Shading: normals turned by {:.1f}° on average"): (
        "Schattierung: Normalen im Mittel um {:.1f}° gedreht"
    ),
    ("*", "Parts: scaled by {:.2f} to {:.2f}"): "Teile: um {:.2f} bis {:.2f} skaliert",
    ("Operator", "Show Views"): "Ansichten zeigen",
    (
        "*",
        "Render the four views that the guide sees of the active object as it is now, as the image "
        "Boxmorph Views. To see what is judged where a score surprises",
    ): (
        "Die vier Ansichten, die das Leitmodell vom aktiven Objekt sieht, wie es jetzt ist, als Bild "
        "„Boxmorph Views“ rendern. Um zu sehen, was beurteilt wird, wo eine Bewertung überrascht"
    ),
    # The guide and the preferences.
    ("*", "The text–image model that judges. Change it for what the embedded one does not know"): (
        "Das Text-Bild-Modell, das urteilt. Wechseln für das, was das eingebaute nicht kennt"
    ),
    ("Boxmorph", "Embedded"): "Eingebaut",
    ("*", "The small guide inside the extension: 249 names, offline, fast"): (
        "Das kleine Leitmodell in der Erweiterung: 249 Namen, offline, schnell"
    ),
    ("Boxmorph", "Folder…"): "Ordner …",
    ("*", "A guide anywhere else on the disk"): "Ein Leitmodell irgendwo sonst auf der Platte",
    ("*", "The guide in {}"): "Das Leitmodell in {}",
    ("*", "Guide Folder"): "Ordner des Leitmodells",
    ("*", "Folder of a guide (ONNX files, tokenizer and configuration). Empty: the embedded guide"): (
        "Ordner eines Leitmodells (ONNX-Dateien, Tokenizer und Konfiguration). Leer: das eingebaute "
        "Leitmodell"
    ),
    ("*", "Guides Folder"): "Ordner für Leitmodelle",
    (
        "*",
        "Folder whose sub-folders are offered as guides. Empty: one beside Blender's settings. Name "
        "another to keep large guides on another disk",
    ): (
        "Ordner, dessen Unterordner als Leitmodelle angeboten werden. Leer: einer neben Blenders "
        "Einstellungen. Einen anderen nennen, um große Leitmodelle auf einer anderen Platte zu "
        "halten"
    ),
    ("*", "{count} in it, {size}. Else only your last prompts are kept"): (
        "Darin {count}, {size}. Sonst werden nur Ihre letzten Prompts gespeichert"
    ),
    ("*", "1 folder"): "1 Ordner",
    ("*", "{} folders"): "{} Ordner",
    ("Operator", "Open Guides Folder"): "Ordner für Leitmodelle öffnen",
    (
        "*",
        "Show the guides folder in the file manager, to put guides into it or delete them. Guides "
        "and your last prompts are all that Boxmorph keeps on the disk; it caches nothing",
    ): (
        "Den Ordner für Leitmodelle im Dateimanager zeigen, um dort Leitmodelle abzulegen oder zu "
        "löschen. Leitmodelle und Ihre letzten Prompts sind alles, was Boxmorph auf der Platte hält; "
        "einen Cache gibt es nicht"
    ),
    ("Operator", "Check Guide"): "Leitmodell prüfen",
    ("*", "Open the chosen guide again, and say what it is or why it cannot be used"): (
        "Das gewählte Leitmodell noch einmal öffnen und sagen, was es ist oder warum es nicht verwendbar ist"
    ),
    ("*", "Not opened yet"): "Noch nicht geöffnet",
    ("*", "“{name}” knows {known}, sees images of {pixels} pixels"): (
        "„{name}“ kennt {known}, sieht Bilder von {pixels} Pixeln"
    ),
    ("*", "{} names"): "{} Namen",
    ("*", "any words"): "beliebige Wörter",
    ("*", "inside the extension"): "in der Erweiterung",
    ("*", "What It Runs On"): "Worauf es läuft",
    (
        "*",
        "A library of ONNX Runtime of your own, for a graphics card. Empty: the one inside the "
        "extension. Read when Blender first uses a guide",
    ): (
        "Eine eigene Bibliothek von ONNX Runtime, für eine Grafikkarte. Leer: die in der "
        "Erweiterung. Gelesen, wenn Blender zum ersten Mal ein Leitmodell verwendet"
    ),
    ("*", "ONNX Runtime {version} offers: {offered}. In use: {used}"): (
        "ONNX Runtime {version} bietet: {offered}. In Gebrauch: {used}"
    ),
    ("*", "The library named above is used once Blender starts again"): (
        "Die oben genannte Bibliothek wird verwendet, sobald Blender neu startet"
    ),
    ("*", "Provider"): "Provider",
    (
        "*",
        "What the guide encodes images on. Change it where a large guide is slow and your ONNX "
        "Runtime library has something faster. Scores then differ in the last digits",
    ): (
        "Worauf das Leitmodell Bilder kodiert. Ändern, wo ein großes Leitmodell langsam ist und die "
        "eigene ONNX-Runtime-Bibliothek etwas Schnelleres hat. Bewertungen weichen dann in den "
        "letzten Stellen ab"
    ),
    (
        "*",
        "The processor, so that results are the same everywhere; a large guide runs on the graphics "
        "card where an ONNX Runtime library of your own has one",
    ): (
        "Der Prozessor, so dass Ergebnisse überall gleich sind; ein großes Leitmodell läuft auf der "
        "Grafikkarte, wo eine eigene ONNX-Runtime-Bibliothek eine hat"
    ),
    ("*", "Processor"): "Prozessor",
    ("*", "The processor, by ONNX Runtime itself"): "Der Prozessor, durch ONNX Runtime selbst",
    ("*", "NVIDIA graphics cards, if the ONNX Runtime library has it"): (
        "NVIDIA-Grafikkarten, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Any graphics card under Windows, if the ONNX Runtime library has it"): (
        "Jede Grafikkarte unter Windows, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Apple's processors, if the ONNX Runtime library has it"): (
        "Apples Prozessoren, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "AMD graphics cards, if the ONNX Runtime library has it"): (
        "AMD-Grafikkarten, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Intel's graphics and processors, if the ONNX Runtime library has it"): (
        "Intels Grafik und Prozessoren, wenn die ONNX-Runtime-Bibliothek es hat"
    ),
    ("*", "Renderer"): "Renderer",
    ("*", "What renders the views that the guide sees. Change it where a driver makes trouble"): (
        "Was die Ansichten rendert, die das Leitmodell sieht. Ändern, wo ein Grafiktreiber Ärger macht"
    ),
    ("*", "The graphics card where there is a real one, else the processor"): (
        "Die Grafikkarte, wo es eine echte gibt, sonst der Prozessor"
    ),
    ("*", "Render the guide's views on the processor. Choose it where a driver makes trouble"): (
        "Die Ansichten des Leitmodells auf dem Prozessor rendern. Wählen, wo ein Grafiktreiber Ärger macht"
    ),
    ("*", "Graphics Card"): "Grafikkarte",
    ("*", "Render the guide's views on the graphics card, even one that the processor plays"): (
        "Die Ansichten des Leitmodells auf der Grafikkarte rendern, selbst auf einer, die der "
        "Prozessor spielt"
    ),
    ("*", "Threads"): "Threads",
    (
        "*",
        "Processor threads that a search may use; 0 means all. Lower it to work on meanwhile. Read "
        "when Blender first searches",
    ): (
        "Threads des Prozessors, die eine Suche verwenden darf; 0 heißt alle. Verringern, um "
        "nebenher weiterzuarbeiten. Gelesen, wenn Blender zum ersten Mal sucht"
    ),
    ("Operator", "Preferences"): "Einstellungen",
    # The report on a bug.
    ("*", "Something Is Wrong?"): "Etwas stimmt nicht?",
    ("Operator", "Copy Report"): "Bericht kopieren",
    ("Operator", "Report as Text"): "Bericht als Text",
    (
        "*",
        "Put a text on the clipboard that says what Boxmorph is doing: versions, settings, counts of "
        "the active object, what was refused last. For a report on a bug; it names no user, and "
        "nothing is sent",
    ): (
        "Einen Text in die Zwischenablage legen, der sagt, was Boxmorph tut: Versionen, "
        "Einstellungen, Zahlen zum aktiven Objekt, was zuletzt abgelehnt wurde. Für die Meldung "
        "eines Fehlers; er nennt keinen Benutzer, und nichts wird gesendet"
    ),
    ("*", "As Text"): "Als Text",
    ("*", "Put it into the text “Boxmorph Report” of this file instead, to read it first"): (
        "Ihn stattdessen in den Text „Boxmorph Report“ dieser Datei schreiben, um ihn erst zu lesen"
    ),
}
